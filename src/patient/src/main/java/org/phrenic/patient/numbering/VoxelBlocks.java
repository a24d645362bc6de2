package org.phrenic.patient.numbering;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.OptionalInt;
import org.phrenic.mesh.IntList;
import org.phrenic.patient.segmentation.Segmentation;

/** Voxels of a part in blocks that follow each other, by whose boxes the nearest voxel to a point is soon found. */
final class VoxelBlocks {
    private static final int SIZE = 64;

    private final Segmentation s;
    private final IntList voxels;
    /** Least x, y and z, then greatest, of each block, mm. */
    private final List<double[]> boxes = new ArrayList<>();

    private int known;

    VoxelBlocks(Segmentation s, IntList voxels) {
        this.s = s;
        this.voxels = voxels;
        extend();
    }

    /** Takes in the voxels that have been added to the list since. */
    void extend() {
        for (; known < voxels.size(); known++) {
            if (known % SIZE == 0) {
                double[] none = new double[6];
                Arrays.fill(none, 0, 3, Double.POSITIVE_INFINITY);
                Arrays.fill(none, 3, 6, Double.NEGATIVE_INFINITY);
                boxes.add(none);
            }
            double[] box = boxes.get(boxes.size() - 1);
            for (int axis = 0; axis < 3; axis++) {
                double at = s.coordinate(voxels.get(known), axis);
                box[axis] = Math.min(box[axis], at);
                box[3 + axis] = Math.max(box[3 + axis], at);
            }
        }
    }

    /** Distance of a point from the nearest voxel, mm. */
    double distance(double[] point) {
        return Math.sqrt(leastSquare(point, Double.POSITIVE_INFINITY));
    }

    /** Square of that distance if it is less than a limit, otherwise the limit. */
    private double leastSquare(double[] point, double limit) {
        double least = limit;
        for (int block = 0; block < boxes.size(); block++) {
            double[] box = boxes.get(block);
            double toBox = 0;
            for (int axis = 0; axis < 3; axis++) {
                double d = Math.max(0, Math.max(box[axis] - point[axis], point[axis] - box[3 + axis]));
                toBox += d * d;
            }
            int end = toBox < least ? Math.min(voxels.size(), (block + 1) * SIZE) : 0;
            for (int i = block * SIZE; i < end; i++) {
                double square = 0;
                for (int axis = 0; axis < 3; axis++) {
                    double d = s.coordinate(voxels.get(i), axis) - point[axis];
                    square += d * d;
                }
                least = Math.min(least, square);
            }
        }
        return least;
    }

    /** Index of the part nearest to a point, the first of several; empty if none is nearer than a distance in mm. */
    static OptionalInt nearest(List<VoxelBlocks> parts, double[] point, double withinMm) {
        double least = withinMm * withinMm;
        OptionalInt nearest = OptionalInt.empty();
        for (int part = 0; part < parts.size(); part++) {
            double square = parts.get(part).leastSquare(point, least);
            if (Math.sqrt(square) < Math.sqrt(least)) {
                least = square;
                nearest = OptionalInt.of(part);
            }
        }
        return nearest;
    }
}
