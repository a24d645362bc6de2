package org.phrenic.engine.force;

import java.util.List;

/** One edge at a time, as the formula stands: what the faster ones are held against. */
final class ReferenceMath implements EdgeMath {

    @Override
    public List<EdgeBatch.Pass> passes(EdgeConstants constants) {
        return List.of((t, from, n) -> {
            for (int i = 0; i < n; i++) {
                force(t, constants, i, from + i);
            }
        });
    }

    private static void force(EdgeBatch t, EdgeConstants c, int i, int entry) {
        double dx = t.difference[i];
        double dy = t.difference[i + EdgeBatch.SIZE];
        double dz = t.difference[i + 2 * EdgeBatch.SIZE];
        double inverse = 1 / Math.sqrt(dx * dx + dy * dy + dz * dz);
        double rest = c.rest[entry];
        if (c.shortening != null) {
            rest -= c.activation * c.shortening[entry];
        }
        double tension = c.stiffness[entry] * (1 - rest * inverse);
        if (c.damping != 0) {
            double along = t.rate[i] * dx + t.rate[i + EdgeBatch.SIZE] * dy + t.rate[i + 2 * EdgeBatch.SIZE] * dz;
            tension += c.damping * (along * (inverse * inverse));
        }
        t.difference[i] = dx * tension;
        t.difference[i + EdgeBatch.SIZE] = dy * tension;
        t.difference[i + 2 * EdgeBatch.SIZE] = dz * tension;
    }
}
