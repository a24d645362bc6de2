"""Writes the volumes of this folder: small labels and images in the formats of several programs.

    pip install numpy pydicom==3.0.2 highdicom==0.28.2 nibabel==5.4.2 pynrrd==1.1.3 SimpleITK==2.5.7 \
        opencv-python-headless==5.0.0.93
    python make_fixtures.py

Each file NAME has a twin NIfTI file, written by nibabel or SimpleITK, with the labels or values that a reader has to
give. All volumes lie obliquely: 8 columns, 7 rows and 6 slices of 2 x 1.5 x 3 mm, turned about two axes.
"""
import os

import cv2
import highdicom as hd
import nibabel as nib
import nrrd
import numpy as np
import pydicom
import SimpleITK as sitk
from pydicom.dataset import Dataset, FileMetaDataset
from pydicom.sequence import Sequence
from pydicom.sr.codedict import codes
from pydicom.uid import (
    CTImageStorage, DeflatedExplicitVRLittleEndian, ExplicitVRBigEndian, ExplicitVRLittleEndian,
    ImplicitVRLittleEndian, RLELossless, RTStructureSetStorage)

HERE = os.path.dirname(os.path.abspath(__file__))
COLUMNS, ROWS, SLICES = 8, 7, 6
SPACING = np.array([2.0, 1.5, 3.0])
ROOT = "1.2.826.0.1.3680043.8.498.1"
SERIES = ROOT + ".2"


def rotation(axis, degrees):
    c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    return np.array({"x": [[1, 0, 0], [0, c, -s], [0, s, c]], "z": [[c, -s, 0], [s, c, 0], [0, 0, 1]]}[axis])


DIRECTIONS = np.round(rotation("z", 20) @ rotation("x", 15), 9)
ORIGIN = np.array([-31.5, 12.25, 440.0])
LPS = np.eye(4)
LPS[:3, :3] = DIRECTIONS * SPACING
LPS[:3, 3] = ORIGIN
RAS = np.diag([-1, -1, 1, 1]) @ LPS


def path(name):
    return os.path.join(HERE, name)


def structures():
    """Masks by label as [label][i, j, k]: a block with a hole, a rod in it, a plate that overlaps the block."""
    masks = {n: np.zeros((COLUMNS, ROWS, SLICES), bool) for n in (1, 2, 5)}
    masks[1][1:7, 1:6, 0:5] = True
    masks[1][3:5, 3, 1:4] = False
    masks[2][3:5, 3, 1:3] = True
    masks[5][5:8, 2:6, 3:6] = True
    return masks


def merged(masks):
    """A voxel belongs to the structure with the fewest voxels, of equal ones to the later."""
    labels = np.zeros((COLUMNS, ROWS, SLICES), np.uint8)
    for number in sorted(masks, key=lambda n: -masks[n].sum()):
        labels[masks[number]] = number
    return labels


def ct_series():
    rng = np.random.default_rng(7)
    stored = rng.integers(0, 4096, (COLUMNS, ROWS, SLICES)).astype(np.uint16)
    os.makedirs(path("ct"), exist_ok=True)
    images = []
    for k in range(SLICES):
        d = Dataset()
        d.file_meta = FileMetaDataset()
        d.file_meta.TransferSyntaxUID = [ExplicitVRLittleEndian, ImplicitVRLittleEndian][k % 2]
        d.file_meta.MediaStorageSOPClassUID = d.SOPClassUID = CTImageStorage
        d.file_meta.MediaStorageSOPInstanceUID = d.SOPInstanceUID = f"{SERIES}.{k + 1}"
        d.PatientID = d.PatientName = "phantom"
        d.PatientBirthDate = d.PatientSex = d.AccessionNumber = d.StudyID = ""
        d.StudyDate, d.StudyTime = "20200101", "000000"
        d.StudyInstanceUID, d.SeriesInstanceUID, d.FrameOfReferenceUID = ROOT + ".1", SERIES, ROOT + ".3"
        d.Modality, d.SeriesNumber, d.InstanceNumber = "CT", 1, k + 1
        d.PositionReferenceIndicator = ""
        d.ImagePositionPatient = [round(float(v), 6) for v in ORIGIN + LPS[:3, 2] * k]
        d.ImageOrientationPatient = [float(v) for v in [*DIRECTIONS[:, 0], *DIRECTIONS[:, 1]]]
        d.PixelSpacing = [SPACING[1], SPACING[0]]
        d.SliceThickness = SPACING[2]
        d.Rows, d.Columns, d.SamplesPerPixel, d.PhotometricInterpretation = ROWS, COLUMNS, 1, "MONOCHROME2"
        d.BitsAllocated, d.BitsStored, d.HighBit, d.PixelRepresentation = 16, 12, 11, 0
        d.RescaleSlope, d.RescaleIntercept = 1.5, -1024
        d.PixelData = stored[:, :, k].T.tobytes()
        # Names in another order than places, as some archives have them.
        d.save_as(path(f"ct/IM{(5 * k + 2) % SLICES}.dcm"), enforce_file_format=True)
        images.append(d)
    read = sitk.ReadImage([path(f"ct/IM{(5 * k + 2) % SLICES}.dcm") for k in range(SLICES)])
    sitk.WriteImage(sitk.Cast(read, sitk.sitkFloat32), path("ct_twin.nii.gz"))
    return images


def description(number, name):
    return hd.seg.SegmentDescription(
        segment_number=number, segment_label=name, segmented_property_category=codes.SCT.Organ,
        segmented_property_type=codes.SCT.Liver, algorithm_type=hd.seg.SegmentAlgorithmTypeValues.MANUAL)


def segmentation(images, name, masks, kind, syntax=ExplicitVRLittleEndian, omit=True):
    ordered = sorted(masks)
    if kind == "BINARY":
        pixels = np.stack([masks[n].transpose(2, 1, 0) for n in ordered], axis=-1).astype(np.uint8)
    else:
        own = merged(masks)
        pixels = np.zeros_like(own)
        for row, n in enumerate(ordered):
            pixels[own == n] = row + 1
        pixels = pixels.transpose(2, 1, 0)
    seg = hd.seg.Segmentation(
        source_images=images, pixel_array=pixels, segmentation_type=kind,
        segment_descriptions=[description(r + 1, {1: "liver", 2: "cyst", 5: "Milz \u00e4"}[n])
                              for r, n in enumerate(ordered)],
        series_instance_uid=ROOT + ".4", series_number=2, sop_instance_uid=ROOT + ".4.1", instance_number=1,
        manufacturer="phantom", manufacturer_model_name="phantom", software_versions="1", device_serial_number="1",
        omit_empty_frames=omit, transfer_syntax_uid=syntax)
    seg.save_as(path(name))
    return seg


def recoded(source, name, syntax):
    d = pydicom.dcmread(path(source))
    d.file_meta.TransferSyntaxUID = syntax
    d.save_as(path(name), implicit_vr=syntax == ImplicitVRLittleEndian)


def big_endian(source, name):
    """Pixels as 16-bit words (OW), so that the bytes of each pair are exchanged."""
    read = pydicom.dcmread(path(source))
    read.walk(lambda data, element: element.value)
    d = pydicom.Dataset(read)
    d.file_meta = read.file_meta
    d.file_meta.TransferSyntaxUID = ExplicitVRBigEndian
    d["PixelData"].VR = "OW"
    d.PixelData = np.frombuffer(d.PixelData, np.uint16).byteswap().tobytes()
    d.save_as(path(name), implicit_vr=False, little_endian=False, enforce_file_format=True)


def turned_frames(source, name):
    """The frames in another order, with orientation and spacing for each instead of for all."""
    d = pydicom.dcmread(path(source))
    order = np.random.default_rng(3).permutation(int(d.NumberOfFrames))
    shared = d.SharedFunctionalGroupsSequence[0]
    frames = np.unpackbits(np.frombuffer(d.PixelData, np.uint8), bitorder="little")
    frames = frames[:int(d.NumberOfFrames) * ROWS * COLUMNS].reshape(-1, ROWS * COLUMNS)
    d.PixelData = np.packbits(frames[order].ravel(), bitorder="little").tobytes()
    if len(d.PixelData) % 2:
        d.PixelData += b"\0"
    groups = [d.PerFrameFunctionalGroupsSequence[int(f)] for f in order]
    for group in groups:
        group.PlaneOrientationSequence = shared.PlaneOrientationSequence
        group.PixelMeasuresSequence = shared.PixelMeasuresSequence
    d.PerFrameFunctionalGroupsSequence = Sequence(groups)
    del shared.PlaneOrientationSequence
    del shared.PixelMeasuresSequence
    d.save_as(path(name))


def outline(mask):
    """Closed polygons along the edges of the pixels of a slice, outer ones and holes, as lists of (i, j)."""
    edges = {}
    for i, j in zip(*np.nonzero(mask)):
        for (di, dj), a, b in [((0, -1), (0, 0), (1, 0)), ((1, 0), (1, 0), (1, 1)),
                               ((0, 1), (1, 1), (0, 1)), ((-1, 0), (0, 1), (0, 0))]:
            u, v = i + di, j + dj
            if not (0 <= u < mask.shape[0] and 0 <= v < mask.shape[1] and mask[u, v]):
                edges.setdefault((i + a[0], j + a[1]), []).append((i + b[0], j + b[1]))
    polygons = []
    while edges:
        start = at = next(iter(edges))
        polygon = []
        while True:
            polygon.append((at[0] - 0.5, at[1] - 0.5))
            following = edges[at].pop()
            if not edges[at]:
                del edges[at]
            at = following
            if at == start:
                break
        polygons.append(polygon)
    return polygons


def pixel_outline(mask):
    """Outlines through the centres of the outermost pixels, as rt-utils (so TotalSegmentator) writes them."""
    found, _ = cv2.findContours(mask.T.astype(np.uint8), cv2.RETR_TREE, cv2.CHAIN_APPROX_SIMPLE)
    return [[(int(i), int(j)) for i, j in polygon[:, 0]] for polygon in found]


def scattered():
    """Masks by label: pixels at random in four slices, so lines, dots and holes; in two, frames within frames."""
    labels = np.random.default_rng(11).choice([0, 1, 2, 5], (COLUMNS, ROWS, SLICES), p=[0.35, 0.35, 0.2, 0.1])
    i, j = np.indices((COLUMNS, ROWS))
    depth = np.minimum.reduce([i, COLUMNS - 1 - i, j, ROWS - 1 - j])
    labels[:, :, 4:] = np.array([1, 2, 1, 5])[depth][:, :, None]
    return {n: labels == n for n in (1, 2, 5)}


def keyhole(polygons):
    """One polygon of an outer one and a hole, joined by a cut that is passed twice."""
    outer, hole = sorted(polygons, key=lambda p: -np.ptp(np.array(p), axis=0).prod())
    return [outer + [outer[0]] + hole + [hole[0]]]


def structure_set(images, name, masks, syntax=ImplicitVRLittleEndian, across=(), draw=outline, refers=(SERIES,), affine=LPS):
    """`across`: a polygon of the first region that lies in no slice, as a list of (i, j, k)."""
    d = Dataset()
    d.file_meta = FileMetaDataset()
    d.file_meta.TransferSyntaxUID = syntax
    d.file_meta.MediaStorageSOPClassUID = d.SOPClassUID = RTStructureSetStorage
    d.file_meta.MediaStorageSOPInstanceUID = d.SOPInstanceUID = ROOT + ".5.1"
    d.PatientID = d.PatientName = "phantom"
    d.StudyInstanceUID, d.SeriesInstanceUID, d.Modality = ROOT + ".1", ROOT + ".5", "RTSTRUCT"
    d.SpecificCharacterSet = "ISO_IR 192"
    series = [Dataset() for _ in refers]
    for one, uid in zip(series, refers):
        one.SeriesInstanceUID = uid
    study = Dataset()
    study.RTReferencedSeriesSequence = Sequence(series)
    frame = Dataset()
    frame.FrameOfReferenceUID = ROOT + ".3"
    frame.RTReferencedStudySequence = Sequence([study])
    d.ReferencedFrameOfReferenceSequence = Sequence([frame])
    regions, contoured = [], []
    for number, mask in masks.items():
        region = Dataset()
        region.ROINumber, region.ROIName = number, {1: "liver", 2: "cyst", 5: "Milz \u00e4"}[number]
        regions.append(region)
        drawn = [across] if across and not contoured else []
        for k in range(SLICES):
            polygons = draw(mask[:, :, k])
            if len(polygons) == 2 and k == 3 and draw is outline:
                polygons = keyhole(polygons)
            drawn += [[(i, j, k) for i, j in polygon] for polygon in polygons]
        contours = []
        for polygon in drawn:
            c = Dataset()
            points = [affine[:3, :3] @ np.array(corner) + affine[:3, 3] for corner in polygon]
            c.ContourGeometricType, c.NumberOfContourPoints = "CLOSED_PLANAR", len(polygon)
            c.ContourData = [f"{v:.4f}" for p in points for v in p]
            contours.append(c)
        one = Dataset()
        one.ReferencedROINumber, one.ContourSequence = number, Sequence(contours)
        contoured.append(one)
    d.StructureSetROISequence, d.ROIContourSequence = Sequence(regions), Sequence(contoured)
    d.save_as(path(name), enforce_file_format=True)


def twin(name, labels):
    image = nib.Nifti1Image(labels, RAS)
    image.header.set_xyzt_units("mm", "sec")
    nib.save(image, path(name))


def layers(name, masks):
    """Segments 0 to 2 in two layers, as 3D Slicer puts overlapping ones: the first and second share a layer."""
    header = {"space": "left-posterior-superior", "space origin": ORIGIN, "encoding": "gzip",
              "kinds": ["list", "domain", "domain", "domain"],
              "space directions": np.vstack([[np.nan] * 3, LPS[:3, :3].T])}
    stored = np.zeros((2, COLUMNS, ROWS, SLICES), np.uint8)
    for row, (number, layer, value) in enumerate([(1, 0, 1), (2, 1, 1), (5, 1, 2)]):
        stored[layer][masks[number]] = value
        header[f"Segment{row}_ID"] = f"Segment_{number}"
        header[f"Segment{row}_Name"] = {1: "liver", 2: "cyst", 5: "spleen"}[number]
        header[f"Segment{row}_LabelValue"], header[f"Segment{row}_Layer"] = str(value), str(layer)
    nrrd.write(path(name), stored, header)


def phases():
    """The stored values of the series and the same with 10, 20 added, as volumes along time."""
    one = np.asarray(nib.load(path("ct_twin.nii.gz")).dataobj).astype(np.int16)
    four = np.stack([one, one + 10, one + 20], axis=-1)
    nib.save(nib.Nifti2Image(four, RAS), path("phases_nifti2.nii"))
    nib.save(nib.Nifti1Image(four.astype(">i2"), RAS, nib.Nifti1Header(endianness=">")), path("phases.nii.gz"))
    header = {"space": "left-posterior-superior", "space origin": ORIGIN, "encoding": "gzip",
              "kinds": ["list", "domain", "domain", "domain"],
              "space directions": np.vstack([[np.nan] * 3, LPS[:3, :3].T])}
    nrrd.write(path("phases.seq.nrrd"), np.moveaxis(four, -1, 0), header)
    nib.save(nib.Nifti1Image(one, RAS), path("phases_twin.nii.gz"))


def metaimages(masks):
    """Labels and phases by SimpleITK; the phases are those of phases_twin.nii.gz with 10 and 20 added."""
    def placed(values):
        image = sitk.GetImageFromArray(values.transpose(2, 1, 0))
        image.SetSpacing(SPACING.tolist())
        image.SetOrigin(ORIGIN.tolist())
        image.SetDirection(DIRECTIONS.ravel().tolist())
        return image

    sitk.WriteImage(placed(merged(masks)), path("labels.mha"), useCompression=True)
    one = np.asarray(nib.load(path("phases_twin.nii.gz")).dataobj).astype(np.int16)
    sitk.WriteImage(sitk.JoinSeries([placed(one + n) for n in (0, 10, 20)]), path("phases.mha"))


def main():
    masks = structures()
    apart = {n: merged(masks) == n for n in masks}
    numbered = {row + 1: masks[n] for row, n in enumerate(sorted(masks))}
    images = ct_series()
    twin("labels_twin.nii.gz", merged(numbered))
    twin("regions_twin.nii.gz", merged(masks))
    segmentation(images, "overlapping_seg.dcm", masks, "BINARY")
    turned_frames("overlapping_seg.dcm", "turned_seg.dcm")
    segmentation(images, "apart_seg.dcm", apart, "BINARY", omit=False)
    segmentation(images, "map_seg.dcm", masks, "LABELMAP")
    segmentation(images, "map_rle_seg.dcm", masks, "LABELMAP", RLELossless)
    recoded("overlapping_seg.dcm", "implicit_seg.dcm", ImplicitVRLittleEndian)
    recoded("overlapping_seg.dcm", "deflated_seg.dcm", DeflatedExplicitVRLittleEndian)
    big_endian("overlapping_seg.dcm", "big_endian_seg.dcm")
    big_endian("map_seg.dcm", "map_big_endian_seg.dcm")
    structure_set(images, "ct/contours.dcm", masks)
    structure_set(images, "ct/contours_big_endian.dcm", masks, ExplicitVRBigEndian)
    structure_set(images, "contours_alone.dcm", {1: masks[1]})
    sparse = np.zeros_like(masks[1])
    sparse[1:7, 1:6, 0:5:2] = True
    structure_set(images, "ct/contours_sparse.dcm", {1: sparse}, across=[(3, 1, 0), (3, 5, 0), (3, 5, 4), (3, 1, 4)])
    structure_set(images, "contours_of_two.dcm", masks, refers=(ROOT + ".0", SERIES))
    structure_set(images, "ct/contours_pixels.dcm", scattered(), draw=pixel_outline)
    twin("scattered_twin.nii.gz", merged(scattered()))
    axial = np.diag([0.9765625, 0.9765625, 3, 1])
    axial[:3, 3] = -250, -241.7, 100
    structure_set(images, "pixels_alone.dcm", scattered(), draw=pixel_outline, affine=axial)
    structure_set(images, "edges_alone.dcm", scattered(), affine=axial)
    layers("overlapping.seg.nrrd", masks)
    phases()
    metaimages(numbered)


if __name__ == "__main__":
    main()
