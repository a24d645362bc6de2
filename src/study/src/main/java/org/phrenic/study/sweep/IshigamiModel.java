package org.phrenic.study.sweep;

import java.util.List;
import org.phrenic.file.Hashes;
import org.phrenic.file.Numbers;

/**
 * The function of Ishigami and Homma 1990, whose sensitivity indices are known: y = sin x1 + a sin<sup>2</sup> x2 + b
 * x3<sup>4</sup> sin x1 with a = 7, b = 0.1 and all x uniform between -&pi; and &pi;. First-order indices 0.3139,
 * 0.4424, 0; total indices 0.5576, 0.4424, 0.2437. A study of it checks an installation in a second.
 */
final class IshigamiModel implements SweepModel {
    static final String NAME = "ishigami";

    private static final List<String> KEYS = List.of("x1", "x2", "x3");
    private static final double A = 7;
    private static final double B = 0.1;

    @Override
    public List<String> responses() {
        return List.of("y");
    }

    @Override
    public List<String> series() {
        return List.of();
    }

    @Override
    public double[] limits(String key) {
        if (!KEYS.contains(key)) {
            throw new IllegalArgumentException("factor '" + key + "': found an unknown factor, expected x1, x2 or x3");
        }
        return new double[] {-Math.PI, Math.PI};
    }

    @Override
    public void check(String key, String value) {
        limits(key);
        if (Numbers.parse(value).isEmpty()) {
            throw new IllegalArgumentException("factor '" + key + "': found '" + value + "', expected a number");
        }
    }

    @Override
    public SweepOutcome evaluate(SweepPoint point) {
        double[] x = new double[KEYS.size()];
        for (int i = 0; i < point.keys().size(); i++) {
            x[KEYS.indexOf(point.keys().get(i))] =
                    Numbers.parse(point.values().get(i)).orElseThrow();
        }
        double wave = StrictMath.sin(x[0]);
        double hill = StrictMath.sin(x[1]);
        double[] y = {wave + A * hill * hill + B * x[2] * x[2] * x[2] * x[2] * wave};
        return new SweepOutcome(y, Hashes.sha256(x, y), new double[0][]);
    }
}
