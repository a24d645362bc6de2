package org.phrenic.access;

import java.util.List;
import java.util.function.Function;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.simulation.observe.Surface;

/** The midline of a body, found from its own structures: the origin of a scan may lie anywhere. */
public final class Midline {
    /** Structures in the middle of the body, the best first. */
    private static final List<StructureKind> IN_THE_MIDDLE =
            List.of(StructureKind.STERNUM, StructureKind.VERTEBRA, StructureKind.SKIN);

    private Midline() {}

    /**
     * The x coordinate of the midline, mm: the middle of the sternum, else of the vertebrae, else of the skin; 0 if the
     * body has none of them.
     *
     * @param structures structures of the body
     * @param surface surface of a structure
     * @param box bounding box of a structure, low corner and high corner, mm
     */
    public static <T> double x(List<T> structures, Function<T, Surface> surface, Function<T, double[]> box) {
        for (StructureKind kind : IN_THE_MIDDLE) {
            double right = Double.POSITIVE_INFINITY;
            double left = Double.NEGATIVE_INFINITY;
            for (T s : structures) {
                if (surface.apply(s).kind() == kind) {
                    double[] bounds = box.apply(s);
                    right = Math.min(right, bounds[0]);
                    left = Math.max(left, bounds[3]);
                }
            }
            if (right <= left) {
                return 0.5 * (right + left);
            }
        }
        return 0;
    }
}
