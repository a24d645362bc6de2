package org.phrenic.patient.segmentation;

import java.util.Arrays;
import org.phrenic.mesh.voxel.LabelGrid;

/**
 * Filling of holes: background that a structure encloses, such as unlabelled marrow of a bone. Background counts as
 * connected across the faces of voxels.
 */
final class HoleFilling {
    /** Least share of a hole's faces that belong to one structure. Background between several structures is no hole. */
    private static final double LEAST_SHARE = 0.9;

    private HoleFilling() {}

    /** Fills the holes of all segments; returns the number of voxels filled. */
    static int fill(Segmentation s) {
        byte[] background = new byte[LabelGrid.MAX_BYTE_LABEL + 1];
        background[0] = 1;
        VoxelRuns runs = new VoxelRuns(s, background, false);
        // Background that reaches the border of the box is outside.
        boolean[] outside = new boolean[runs.count()];
        for (int run = 0; run < runs.count(); run++) {
            if (touchesBorder(s, runs.from(run), runs.to(run))) {
                outside[runs.component(run)] = true;
            }
        }
        byte[] around = new byte[runs.count()];
        int[] votes = new int[runs.count()];
        forEachFace(s, runs, outside, (hole, segment) -> {
            // Boyer-Moore majority vote: the structure of most faces, if one has more than half.
            if (votes[hole] == 0) {
                around[hole] = segment;
            }
            votes[hole] += segment == around[hole] ? 1 : -1;
        });
        int[] same = new int[runs.count()];
        int[] other = new int[runs.count()];
        forEachFace(s, runs, outside, (hole, segment) -> (segment == around[hole] ? same : other)[hole]++);
        int filled = 0;
        for (int run = 0; run < runs.count(); run++) {
            int hole = runs.component(run);
            if (!outside[hole] && same[hole] >= LEAST_SHARE * (same[hole] + other[hole])) {
                Arrays.fill(s.voxels, runs.from(run), runs.to(run), around[hole]);
                filled += runs.to(run) - runs.from(run);
            }
        }
        return filled;
    }

    private interface Face {
        void of(int hole, byte segment);
    }

    /** Calls a function for each face of background within the box that a segment is beyond. */
    private static void forEachFace(Segmentation s, VoxelRuns runs, boolean[] outside, Face face) {
        int[] steps = s.steps();
        for (int run = 0; run < runs.count(); run++) {
            int hole = runs.component(run);
            for (int v = runs.from(run); !outside[hole] && v < runs.to(run); v++) {
                for (int step : steps) {
                    if (s.voxels[v + step] != 0) {
                        face.of(hole, s.voxels[v + step]);
                    }
                }
            }
        }
    }

    private static boolean touchesBorder(Segmentation s, int from, int to) {
        int row = from / s.columns;
        int j = row % s.rows;
        int k = row / s.rows;
        return from == row * s.columns
                || to == (row + 1) * s.columns
                || j == 0
                || j == s.rows - 1
                || k == 0
                || k == s.slices - 1;
    }
}
