# SPDX-License-Identifier: GPL-3.0-or-later
"""Free surface and body surface of an OpenFOAM case, as VTK surfaces.

On a composite (overset) mesh every place is covered up to three times: by the
background, by the body mesh, and by holes in either. Here the body mesh wins
where it exists, and the background is cut along the outer boundary of the body
mesh, so that the free surface is there exactly once.
"""

from __future__ import annotations

import json
import re
from pathlib import Path

import numpy as np
from vtkmodules.numpy_interface import dataset_adapter as dsa
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkIdList, vtkPoints
from vtkmodules.vtkCommonDataModel import (
    VTK_POLYHEDRON,
    VTK_TETRA,
    vtkCellArray,
    vtkDataObject,
    vtkPolyData,
    vtkStaticPointLocator,
    vtkUnstructuredGrid,
)
from vtkmodules.vtkFiltersCore import (
    vtkAppendFilter,
    vtkAppendPolyData,
    vtkCellDataToPointData,
    vtkCleanPolyData,
    vtkClipPolyData,
    vtkContourFilter,
    vtkImplicitPolyDataDistance,
    vtkPolyDataNormals,
    vtkProbeFilter,
    vtkReverseSense,
    vtkThreshold,
    vtkTriangleFilter,
)
from vtkmodules.vtkIOGeometry import vtkOpenFOAMReader
from vtkmodules.vtkIOParallel import vtkPOpenFOAMReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLPolyDataWriter
from vtkmodules.vtkParallelCore import vtkDummyController

from plunge.results import CaseError, patch_types
from plunge.sections import Section, cut, outlines

HOLE = 2  # cellCellStencil: 0 calculated, 1 interpolated, 2 hole
BACKGROUND = 0  # zoneID of the mesh that the others lie on


def keep_arrays(data: vtkPolyData | vtkUnstructuredGrid, names: list[str]) -> None:
    """Remove all cell and point arrays but those named."""
    for attributes in (data.GetCellData(), data.GetPointData()):
        for name in [attributes.GetArrayName(i) for i in range(attributes.GetNumberOfArrays())]:
            if name not in names:
                attributes.RemoveArray(name)


def select_cells(mesh: vtkUnstructuredGrid, mask: np.ndarray) -> vtkUnstructuredGrid:
    """The cells of mesh where mask is true."""
    wrapped = dsa.WrapDataObject(mesh)
    wrapped.CellData.append(mask.astype(np.uint8), "selected")
    threshold = vtkThreshold()
    threshold.SetInputData(mesh)
    threshold.SetInputArrayToProcess(0, 0, 0, vtkDataObject.FIELD_ASSOCIATION_CELLS, "selected")
    threshold.SetThresholdFunction(vtkThreshold.THRESHOLD_UPPER)
    threshold.SetUpperThreshold(0.5)
    threshold.Update()
    mesh.GetCellData().RemoveArray("selected")
    selected = threshold.GetOutput()
    selected.GetCellData().RemoveArray("selected")
    return selected


def face_rings(cells: vtkUnstructuredGrid, cell: int) -> list[list[int]]:
    """Point numbers around each face of a polyhedron."""
    ids = vtkIdList()
    cells.GetFaceStream(int(cell), ids)
    stream = [ids.GetId(i) for i in range(ids.GetNumberOfIds())]
    rings, at = [], 1
    for _ in range(stream[0]):
        rings.append(stream[at + 1 : at + 1 + stream[at]])
        at += 1 + stream[at]
    return rings


def octants(ring_normals: list[np.ndarray]) -> int:
    """How many octants a cell takes up at a point, from the normals of its faces there.

    One at a corner, two at a node that hangs on an edge, four at one that hangs on a face.
    """
    directions: list[np.ndarray] = []
    for normal in ring_normals:
        if all(abs(normal @ other) < 0.95 for other in directions):
            directions.append(normal)
    return {1: 4, 2: 2}.get(len(directions), 1)


def to_points(cells: vtkUnstructuredGrid, field: str) -> vtkUnstructuredGrid:
    """The cells with their values averaged to the points.

    Where cells of two sizes meet, a cell with a hanging node counts there for as
    many octants as it takes up: else the surface is drawn towards the larger cells.
    """
    merge = vtkAppendFilter()  # closes the seams between the processors' parts
    merge.MergePointsOn()
    merge.AddInputData(cells)
    average = vtkCellDataToPointData()
    average.SetInputConnection(merge.GetOutputPort())
    average.PassCellDataOn()
    average.Update()
    points = average.GetOutput()

    offsets = vtk_to_numpy(points.GetCells().GetOffsetsArray())
    corners = vtk_to_numpy(points.GetCells().GetConnectivityArray())
    places = vtk_to_numpy(points.GetPoints().GetData())
    values = vtk_to_numpy(points.GetPointData().GetArray(field))
    at_point, of_cell, extra = [], [], []
    for cell in np.flatnonzero(vtk_to_numpy(points.GetCellTypesArray()) == VTK_POLYHEDRON):
        own = corners[offsets[cell] : offsets[cell + 1]]
        if np.ptp(values[own]) == 0:
            continue  # far from the surface
        normals: dict[int, list[np.ndarray]] = {}
        for ring in face_rings(points, cell):
            x = places[ring].astype(float)
            normal = np.cross(x[1:-1] - x[0], x[2:] - x[0]).sum(axis=0)
            normal /= max(np.linalg.norm(normal), 1e-300)
            for i in ring:
                normals.setdefault(i, []).append(normal)
        for i, found in normals.items():
            at_point.append(i)
            of_cell.append(cell)
            extra.append(octants(found) - 1)
    if at_point:
        count = np.bincount(corners, minlength=len(places)).astype(float)
        added = np.bincount(at_point, extra, minlength=len(places))
        for i in range(points.GetPointData().GetNumberOfArrays()):
            array = points.GetPointData().GetArray(i)
            old = vtk_to_numpy(array).reshape(len(places), -1)
            cell_values = vtk_to_numpy(points.GetCellData().GetArray(array.GetName())).reshape(len(offsets) - 1, -1)
            total = old * count[:, None]
            np.add.at(total, at_point, np.array(extra)[:, None] * cell_values[of_cell])
            use = added > 0
            old[use] = (total / (count + added)[:, None])[use]
    points.GetCellData().Initialize()
    return points


def match(inner: vtkUnstructuredGrid, boundary: vtkPolyData, outer: vtkUnstructuredGrid) -> None:
    """Give the points of inner that lie on boundary the values that outer has there.

    An average over cells is one-sided on a boundary; with the values of outer
    the surfaces in the two meshes meet.
    """
    probe = vtkProbeFilter()
    probe.SetInputData(boundary)
    probe.SetSourceData(outer)
    probe.Update()
    there = probe.GetOutput().GetPointData()
    valid = vtk_to_numpy(there.GetArray(probe.GetValidPointMaskArrayName()))
    locator = vtkStaticPointLocator()
    locator.SetDataSet(inner)
    locator.BuildLocator()
    ids = np.array([locator.FindClosestPoint(boundary.GetPoint(i)) for i in range(len(valid))], int)
    # Cells that are cut off (holes) leave boundary points that inner does not have.
    apart = np.linalg.norm(
        vtk_to_numpy(inner.GetPoints().GetData())[ids] - vtk_to_numpy(boundary.GetPoints().GetData()), axis=1
    )
    use = (valid > 0) & (apart < 1e-6 * boundary.GetLength())
    for i in range(inner.GetPointData().GetNumberOfArrays()):
        array = inner.GetPointData().GetArray(i)
        vtk_to_numpy(array)[ids[use]] = vtk_to_numpy(there.GetArray(array.GetName()))[use]


def straddling_polyhedra(points: vtkUnstructuredGrid, field: str, level: float) -> vtkUnstructuredGrid:
    """The polyhedra that the level passes through, as tetrahedra about their centres.

    Hexahedra with hanging nodes are polyhedra to VTK, whose own contouring of
    them gives up on some.
    """
    values = vtk_to_numpy(points.GetPointData().GetArray(field))
    offsets = vtk_to_numpy(points.GetCells().GetOffsetsArray())
    corners = vtk_to_numpy(points.GetCells().GetConnectivityArray())
    new_points, tetrahedra = vtkPoints(), vtkCellArray()
    source: list[list[int]] = []  # points that a new point is the mean of
    numbers: dict[int, int] = {}

    def add(of: list[int]) -> int:
        source.append(of)
        return new_points.InsertNextPoint(np.mean([points.GetPoint(i) for i in of], axis=0))

    for cell in np.flatnonzero(vtk_to_numpy(points.GetCellTypesArray()) == VTK_POLYHEDRON):
        own = corners[offsets[cell] : offsets[cell + 1]]
        if values[own].min() >= level or values[own].max() < level:
            continue
        centre = add(own.tolist())
        for face in face_rings(points, cell):
            ring = [numbers[i] if i in numbers else numbers.setdefault(i, add([i])) for i in face]
            for second, third in zip(ring[1:], ring[2:]):
                x = [np.array(new_points.GetPoint(i)) for i in (ring[0], second, third, centre)]
                if np.cross(x[1] - x[0], x[2] - x[0]) @ (x[3] - x[0]) < 0:  # winds the surface
                    second, third = third, second
                tetrahedra.InsertNextCell(4, (ring[0], second, third, centre))

    parts = vtkUnstructuredGrid()
    parts.SetPoints(new_points)
    parts.SetCells(VTK_TETRA, tetrahedra)
    for i in range(points.GetPointData().GetNumberOfArrays()):
        array = points.GetPointData().GetArray(i)
        old = vtk_to_numpy(array)
        new = np.array([old[of].mean(axis=0) for of in source], old.dtype).reshape(len(source), *old.shape[1:])
        dsa.WrapDataObject(parts).PointData.append(new, array.GetName())
    return parts


def isosurface(points: vtkUnstructuredGrid, field: str, level: float = 0.5) -> vtkPolyData:
    """Surface field = level of the point values."""
    regular = select_cells(points, vtk_to_numpy(points.GetCellTypesArray()) != VTK_POLYHEDRON)
    surfaces = []
    for cells in (regular, straddling_polyhedra(points, field, level)):
        if not cells.GetNumberOfCells():
            continue
        contour = vtkContourFilter()
        contour.SetInputData(cells)
        contour.SetInputArrayToProcess(0, 0, 0, vtkDataObject.FIELD_ASSOCIATION_POINTS, field)
        contour.SetValue(0, level)
        contour.ComputeNormalsOff()
        contour.Update()
        surfaces.append(contour.GetOutput())
    return append(surfaces)


def append(parts: list[vtkPolyData]) -> vtkPolyData:
    """One surface from several; points that coincide are merged."""
    together = vtkAppendPolyData()
    for part in parts:
        together.AddInputData(part)
    clean = vtkCleanPolyData()
    clean.SetInputConnection(together.GetOutputPort())
    clean.PointMergingOn()
    clean.SetTolerance(1e-6)  # of the surface's extent
    clean.ConvertPolysToLinesOff()  # what collapses is dropped
    clean.ConvertLinesToPointsOff()
    clean.Update()
    return clean.GetOutput()


def mirrored(surface: vtkPolyData) -> vtkPolyData:
    """The surface and its mirror image in the symmetry plane y = 0."""
    outward = vtkReverseSense()  # a mirror image is wound the other way round
    outward.SetInputData(surface)
    outward.ReverseCellsOn()
    outward.Update()
    image = vtkPolyData()
    image.DeepCopy(outward.GetOutput())
    if image.GetNumberOfPoints():
        vtk_to_numpy(image.GetPoints().GetData())[:, 1] *= -1
    for attributes in (image.GetPointData(), image.GetCellData()):
        for array in (attributes.GetArray(i) for i in range(attributes.GetNumberOfArrays())):
            if array.GetNumberOfComponents() == 3 and array.GetNumberOfTuples():
                vtk_to_numpy(array)[:, 1] *= -1
    return append([surface, image])


def cut_away(surface: vtkPolyData, enclosure: vtkPolyData) -> vtkPolyData:
    """What of surface lies outside the closed surface enclosure (normals outward)."""
    triangles = vtkTriangleFilter()
    triangles.SetInputData(enclosure)
    normals = vtkPolyDataNormals()
    normals.SetInputConnection(triangles.GetOutputPort())
    normals.ConsistencyOn()
    normals.AutoOrientNormalsOn()
    normals.SplittingOff()
    normals.Update()
    distance = vtkImplicitPolyDataDistance()
    distance.SetInput(normals.GetOutput())
    clip = vtkClipPolyData()
    clip.SetInputData(surface)
    clip.SetClipFunction(distance)
    clip.SetValue(0.0)
    clip.InsideOutOff()
    clip.Update()
    return clip.GetOutput()


def free_surface(
    mesh: vtkUnstructuredGrid, alpha: str, overset: list[vtkPolyData], half: bool, fields: list[str]
) -> vtkPolyData:
    """Surface alpha = 0.5 of a mesh, single or composite, carrying the fields.

    mesh has the cell arrays alpha, fields and, if composite, zoneID and cellTypes.
    overset: outer boundaries of the body meshes (empty: a single mesh).
    half: the surfaces end on the symmetry plane y = 0 and are mirrored.
    """
    data = mesh.GetCellData()

    def cell_array(name: str) -> np.ndarray:
        if not data.HasArray(name):
            raise CaseError(f"field {name} is not among the written fields")
        return vtk_to_numpy(data.GetArray(name))

    for name in [alpha, *fields]:
        cell_array(name)
    whole = mirrored if half else (lambda surface: surface)
    if not overset:
        surface = isosurface(to_points(mesh, alpha), alpha)
        keep_arrays(surface, fields)
        return whole(surface)

    zone = np.rint(cell_array("zoneID")).astype(int)
    solved = np.rint(cell_array("cellTypes")).astype(int) != HOLE
    zones = {}
    for number in np.unique(zone):
        zones[number] = to_points(select_cells(mesh, (zone == number) & solved), alpha)
        keep_arrays(zones[number], [alpha, *fields])
    if BACKGROUND not in zones:
        raise CaseError(f"field zoneID has no cell of zone {BACKGROUND}, the background")

    parts = []
    for number, points in zones.items():
        if number != BACKGROUND:
            for boundary in overset:
                match(points, boundary, zones[BACKGROUND])
        part = isosurface(points, alpha)
        keep_arrays(part, fields)
        part = whole(part)
        if number == BACKGROUND:
            for boundary in overset:
                if part.GetNumberOfCells():
                    part = cut_away(part, whole(boundary))
        parts.append(part)
    return append(parts)


class Case:
    """The written times of an OpenFOAM case, reconstructed or decomposed."""

    def __init__(self, directory: Path, alpha: str, body: str) -> None:
        self.directory, self.alpha, self.body = directory, alpha, body
        types = patch_types(directory)
        if body not in types:
            raise CaseError(
                f"{directory}/constant/polyMesh/boundary: no patch '{body}'; "
                f"patches are {', '.join(types)}"
            )
        self.overset = [name for name, kind in types.items() if kind == "overset"]
        self.half = any(kind in ("symmetry", "symmetryPlane") for kind in types.values())
        self.mirrored = "wedge" in types.values()  # a sector about the axis x = y = 0
        self.in_plane = self.mirrored or "empty" in types.values()
        self.axes, self.plane = ("r" if self.mirrored else "x", "z"), ""

        opener = directory / "case.foam"
        opener.touch()
        written = self._numeric(directory)
        parallel = self._numeric(directory / "processor0")
        decomposed = len(parallel) > len(written)
        reader = vtkPOpenFOAMReader() if decomposed else vtkOpenFOAMReader()
        if decomposed:
            reader.SetController(vtkDummyController())  # it crashes without one
            reader.SetCaseType(vtkPOpenFOAMReader.DECOMPOSED_CASE)
        reader.SetFileName(str(opener))
        reader.SkipZeroTimeOff()
        reader.UpdateInformation()
        reader.DisableAllPatchArrays()
        for patch in ["internalMesh"] + [f"patch/{name}" for name in [body, *self.overset]]:
            reader.SetPatchArrayStatus(patch, 1)
        reader.CreateCellToPointOff()
        reader.DecomposePolyhedraOff()  # their parts would count one by one in averages to points
        reader.DisableAllCellArrays()
        reader.DisableAllPointArrays()
        for field in (alpha, "p", "U", "zoneID", "cellTypes"):
            reader.SetCellArrayStatus(field, 1)
        self.reader = reader
        self.times = [float(t) for t in vtk_to_numpy(reader.GetTimeValues())] if reader.GetTimeValues() else []
        if not self.times:
            raise CaseError(f"{directory}: no time directory that holds results")

    @staticmethod
    def _numeric(directory: Path) -> list[Path]:
        return [d for d in directory.glob("*") if d.is_dir() and re.fullmatch(r"[\d.]+(e-?\d+)?", d.name)]

    def _read(self, time: float) -> tuple[vtkUnstructuredGrid, dict[str, list[vtkPolyData]], list[str]]:
        """Mesh, patches and the names of the fields that there are, at a written time in s."""
        self.reader.UpdateTimeStep(time)
        meshes: list[vtkUnstructuredGrid] = []
        patches: dict[str, list[vtkPolyData]] = {}

        def walk(block, name: str) -> None:
            if block is None:
                return
            if block.IsA("vtkMultiBlockDataSet"):
                for i in range(block.GetNumberOfBlocks()):
                    named = block.HasMetaData(i) and block.GetMetaData(i).Has(block.NAME())
                    walk(block.GetBlock(i), block.GetMetaData(i).Get(block.NAME()) if named else "")
            elif block.IsA("vtkUnstructuredGrid"):
                meshes.append(block)
            elif block.GetNumberOfCells():
                patches.setdefault(name, []).append(block)

        walk(self.reader.GetOutput(), "")
        together = vtkAppendFilter()
        for part in meshes:
            together.AddInputData(part)
        together.Update()
        mesh = together.GetOutput()
        mesh.GetPointData().Initialize()  # has motionScale where OpenFOAM was started again
        fields = ["p", "U"] if mesh.GetCellData().HasArray("p") or time != self.times[0] else ["U"]
        for name in (self.alpha, *fields):
            if not mesh.GetCellData().HasArray(name):
                raise CaseError(f"{self.directory}, time {time:g} s: field {name} is not among the written fields")
        return mesh, patches, fields

    def surfaces(self, time: float) -> tuple[vtkPolyData, vtkPolyData]:
        """(free surface, body), both whole, at a written time in s."""
        mesh, patches, fields = self._read(time)
        if self.overset and time == self.times[0] and not mesh.GetCellData().HasArray("cellTypes"):
            # The initial fields precede the first overset assembly: nothing is a hole yet.
            dsa.WrapDataObject(mesh).CellData.append(np.zeros(mesh.GetNumberOfCells()), "cellTypes")
        outer = [append(patches[name]) for name in self.overset if name in patches]
        try:
            surface = free_surface(mesh, self.alpha, outer, self.half, fields)
        except CaseError as error:
            raise CaseError(f"{self.directory}, time {time:g} s: {error}") from None
        hull = append(patches[self.body])
        keep_arrays(hull, fields)
        return surface, mirrored(hull) if self.half else hull

    def section(self, instant: int) -> Section:
        """The flow in the plane of a plane or axisymmetric model, at a written time."""
        mesh, patches, fields = self._read(self.times[instant])
        low, high = mesh.GetBounds()[2:4]
        middle = 0.0 if self.mirrored else 0.5 * (low + high)
        flow = append([cut(to_points(mesh, self.alpha), 1, middle)])
        points = vtk_to_numpy(flow.GetPoints().GetData())[:, [0, 2]]
        triangles = vtk_to_numpy(flow.GetPolys().GetConnectivityArray()).reshape(-1, 3)
        a, b, c = (points[triangles[:, i]] for i in range(3))
        area = (b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0]
        triangles = triangles[np.abs(area) > 1e-12 * np.abs(area).mean()]  # matplotlib takes none that are lines
        values = {name: vtk_to_numpy(flow.GetPointData().GetArray(name)) for name in (self.alpha, *fields)}
        to_corners = vtkCellDataToPointData()
        to_corners.SetInputData(append(patches[self.body]))
        to_corners.Update()
        lines = outlines(to_corners.GetOutput(), 1, middle)
        if self.mirrored:  # from the axis to the axis
            lines = [(np.concatenate((line, line[::-1] * [-1, 1])), None if p is None else np.concatenate((p, p[::-1])))
                     for line, p in lines]
        return Section(self.times[instant], points, values.get("p"), np.linalg.norm(values["U"], axis=1), [line for line, _ in lines],
                       [p for _, p in lines] if "p" in values else None, values[self.alpha], triangles)


class Series:
    """A .vtp.series: one surface for each written time, opened by ParaView as one."""

    def __init__(self, folder: Path, name: str) -> None:
        self.folder, self.name = folder, name
        self.files: list[dict] = []
        folder.mkdir(parents=True, exist_ok=True)
        for old in folder.glob(f"{name}_*.vtp"):
            old.unlink()

    def add(self, time: float, surface: vtkPolyData) -> None:
        """Write the surface at time in s."""
        file = f"{self.name}_{len(self.files):04d}.vtp"
        writer = vtkXMLPolyDataWriter()
        writer.SetFileName(str(self.folder / file))
        writer.SetInputData(surface)
        if not writer.Write():
            raise CaseError(f"{self.folder / file}: cannot be written")
        self.files.append({"name": file, "time": float(time)})
        series = {"file-series-version": "1.0", "files": self.files}
        (self.folder / f"{self.name}.vtp.series").write_text(json.dumps(series, indent=1) + "\n")


def read_series(folder: Path, name: str) -> list[tuple[float, Path]]:
    """(time in s, file) of each surface of a .vtp.series."""
    path = folder / f"{name}.vtp.series"
    if not path.is_file():
        raise CaseError(f"{path}: not found; plungePost writes it for meshes, plungeSPH for particles")
    return [(f["time"], folder / f["name"]) for f in json.loads(path.read_text())["files"]]


def read_surface(path: Path) -> vtkPolyData:
    """The surface in a .vtp file."""
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


def write_surface_series(case: Case, folder: Path) -> dict[str, np.ndarray]:
    """Write both series; return the table time_s, low_m, high_m of the body's lowest and highest point."""
    water, body = Series(folder, "freeSurface"), Series(folder, "body")
    extent = []
    for time in case.times:
        surface, hull = case.surfaces(time)
        water.add(time, surface)
        body.add(time, hull)
        extent.append((time, *hull.GetBounds()[4:6]))
    return dict(zip(("time_s", "low_m", "high_m"), np.array(extent).T))
