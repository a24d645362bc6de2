package org.phrenic.anatomy;

import java.util.List;

/** Bodies whose right lung ends far above the diaphragm, as with fluid below it. */
public final class LungAboveFluid {
    /** Height of the lung below its apex, over that without fluid. */
    private static final double HEIGHT = 0.65;

    private LungAboveFluid() {}

    /** A body with its right lung made less tall. */
    public static Thorax in(Thorax body) {
        return new Thorax(
                "fluid",
                body.structures().stream().map(LungAboveFluid::shortened).toList(),
                List.of());
    }

    private static Structure shortened(Structure s) {
        if (s.kind() != StructureKind.LUNG || s.side() != Side.RIGHT) {
            return s;
        }
        double[] p = s.mesh().positions().clone();
        double apex = s.mesh().bounds()[5];
        for (int i = 2; i < p.length; i += 3) {
            p[i] = apex - HEIGHT * (apex - p[i]);
        }
        return s.withMesh(s.mesh().withPositions(p));
    }
}
