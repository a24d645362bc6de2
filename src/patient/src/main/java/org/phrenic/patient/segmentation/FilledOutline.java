package org.phrenic.patient.segmentation;

import java.util.stream.IntStream;
import org.phrenic.anatomy.OrganNames;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.StructureName;
import org.phrenic.mesh.IntList;
import org.phrenic.mesh.voxel.LabelGrid;

/**
 * The body within its skin: the union of the segments of the body, and what these enclose in a layer across it, as
 * where the skin is labelled as a shell. The ends of a scan above and below do not open a layer. Lesions and unknown
 * structures belong to the body where it encloses them: a couch does not, nor a target volume beyond the skin.
 */
public final class FilledOutline {
    private static final int STEPS = 4;

    private final Segmentation body;
    /** Whether each segment is one of the body; not so background, lesions and unknown structures. */
    private final boolean[] ofBody;

    private final int[] sizes;
    private final int[] strides;
    private final int direction;
    private final int one;
    private final int two;

    private FilledOutline(Segmentation body) {
        this.body = body;
        ofBody = new boolean[LabelGrid.MAX_BYTE_LABEL + 1];
        for (int segment = 1; segment <= body.names().size(); segment++) {
            ofBody[segment] = isOfBody(body.names().get(segment - 1));
        }
        sizes = new int[] {body.columns, body.rows, body.slices};
        strides = new int[] {1, body.columns, body.columns * body.rows};
        direction = IntStream.range(0, 3).filter(body::isAlongBody).findFirst().orElse(2);
        one = (direction + 1) % 3;
        two = (direction + 2) % 3;
    }

    private static boolean isOfBody(String structure) {
        return !structure.startsWith(OrganNames.OTHER_PREFIX)
                && StructureName.parse(structure)
                        .filter(name -> name.kind() == StructureKind.LESION)
                        .isEmpty();
    }

    /**
     * The body as label 1. Layers are filled in the voxels of the scan, for a shell may be one of them thick.
     *
     * @param times factors by which voxels are enlarged, for columns, rows and slices
     */
    public static LabelGrid of(Segmentation body, int[] times) {
        FilledOutline outline = new FilledOutline(body);
        int[] large = IntStream.range(0, 3)
                .map(axis -> (outline.sizes[axis] - 1) / times[axis] + 1)
                .toArray();
        byte[] inside = new byte[large[0] * large[1] * large[2]];
        IntStream.range(0, large[outline.direction])
                .parallel()
                .forEach(layer -> outline.sample(layer, times, large, inside));
        double[] toMm = body.grid().toMm();
        double[] largeToMm = toMm.clone();
        for (int row = 0; row < 3; row++) {
            for (int axis = 0; axis < 3; axis++) {
                largeToMm[4 * row + axis] *= times[axis];
                int middle = times[axis] / 2;
                largeToMm[4 * row + 3] += middle * toMm[4 * row + axis];
            }
        }
        return LabelGrid.of(large[0], large[1], large[2], inside, largeToMm);
    }

    /** Samples a layer of large voxels at their middles. */
    private void sample(int layer, int[] times, int[] large, byte[] inside) {
        boolean[] outside = outside(middle(layer, direction, times));
        int[] largeStrides = {1, large[0], large[0] * large[1]};
        for (int b = 0; b < large[two]; b++) {
            for (int a = 0; a < large[one]; a++) {
                boolean out = outside[middle(a, one, times) + sizes[one] * middle(b, two, times)];
                inside[layer * largeStrides[direction] + a * largeStrides[one] + b * largeStrides[two]] =
                        (byte) (out ? 0 : 1);
            }
        }
    }

    private int middle(int large, int axis, int[] times) {
        return Math.min(sizes[axis] - 1, times[axis] * large + times[axis] / 2);
    }

    /** The voxels of a layer that a path beside the body joins to the layer's border. */
    private boolean[] outside(int layer) {
        boolean[] outside = new boolean[sizes[one] * sizes[two]];
        IntList open = new IntList();
        for (int cell = 0; cell < outside.length; cell++) {
            int a = cell % sizes[one];
            int b = cell / sizes[one];
            if (a == 0 || b == 0 || a == sizes[one] - 1 || b == sizes[two] - 1) {
                reach(layer, a, b, outside, open);
            }
        }
        for (int next = 0; next < open.size(); next++) {
            int a = open.get(next) % sizes[one];
            int b = open.get(next) / sizes[one];
            for (int step = 0; step < STEPS; step++) {
                int na = a + (step == 0 ? 1 : step == 1 ? -1 : 0);
                int nb = b + (step == 2 ? 1 : step == 3 ? -1 : 0);
                if (na >= 0 && nb >= 0 && na < sizes[one] && nb < sizes[two]) {
                    reach(layer, na, nb, outside, open);
                }
            }
        }
        return outside;
    }

    private void reach(int layer, int a, int b, boolean[] outside, IntList open) {
        int cell = a + sizes[one] * b;
        int voxel = layer * strides[direction] + a * strides[one] + b * strides[two];
        if (!outside[cell] && !ofBody[body.segmentAt(voxel)]) {
            outside[cell] = true;
            open.add(cell);
        }
    }
}
