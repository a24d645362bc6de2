"""Prints what SimpleITK and nibabel read of displacement fields: the vector (LPS, mm) at three places (LPS, mm)."""

import sys

import nibabel
import numpy
import SimpleITK

PLACES = [(10.0, -20.0, 5.0), (12.0, -20.0, 5.0), (14.0, -17.0, 9.0)]


def show(reader, name, vector):
    print(reader, name, *("%.4f" % v for v in vector))


for ending in ("nii", "nii.gz", "nrrd", "mha"):
    image = SimpleITK.ReadImage(sys.argv[1] + "/field." + ending)
    for place in PLACES:
        index = image.TransformPhysicalPointToIndex(place)
        show("SimpleITK", ending, image.GetPixel(index))

for ending in ("nii", "nii.gz"):
    image = nibabel.load(sys.argv[1] + "/field." + ending)
    data = image.get_fdata()
    print("nibabel", ending, data.shape, image.header.get_intent()[0], image.header.get_xyzt_units()[0])
    for place in PLACES:
        ras = numpy.array([-place[0], -place[1], place[2], 1.0])
        i, j, k = numpy.rint(numpy.linalg.inv(image.affine) @ ras)[:3].astype(int)
        vector = data[i, j, k, 0]
        show("nibabel", ending, (-vector[0], -vector[1], vector[2]))

series = nibabel.load(sys.argv[1] + "/series.nii.gz")
print("nibabel series", series.shape, series.get_data_dtype(), series.header.get_zooms()[3], int(series.dataobj[1, 1, 1, 1]))
