package org.phrenic.patient.label;

import java.util.OptionalInt;
import org.phrenic.anatomy.OrganNames;
import org.phrenic.mesh.voxel.LabelGrid;

/** Finds a label without a known name that encloses all others: the body, with its organs under labels of their own. */
final class BodyOutline {
    /** Least share of all labelled voxels. */
    private static final double LEAST_SHARE = 0.3;
    /** Largest distance of its bounding box from that of all labels, as a share of the size along each axis. */
    private static final double MARGIN = 0.02;

    private BodyOutline() {}

    /** The label of the body; empty if there is none. */
    static OptionalInt label(LabelGrid grid, LabelTable table) {
        int[] counts = grid.counts();
        long all = 0;
        int largest = 0;
        for (int label = 1; label < counts.length; label++) {
            all += counts[label];
            String structure = table.structures().getOrDefault(label, "");
            boolean unknown = structure.startsWith(OrganNames.OTHER_PREFIX) && !LabelTable.isOfPlan(structure);
            largest = unknown && (largest == 0 || counts[label] > counts[largest]) ? label : largest;
        }
        if (largest == 0 || counts[largest] < LEAST_SHARE * all || counts[largest] == all) {
            return OptionalInt.empty();
        }
        int body = largest;
        int[] own = grid.box(label -> label == body);
        int[] whole = grid.box(label -> label != 0);
        for (int axis = 0; axis < 3; axis++) {
            double margin = MARGIN * (whole[3 + axis] - whole[axis] + 1);
            if (own[axis] - whole[axis] > margin || whole[3 + axis] - own[3 + axis] > margin) {
                return OptionalInt.empty();
            }
        }
        return OptionalInt.of(largest);
    }
}
