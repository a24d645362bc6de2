package org.phrenic.study.sweep;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import org.phrenic.file.Hashes;

/** The runs of a study in the order of its design. The same study gives the same plan. Immutable. */
public final class SweepPlan {
    private static final int FINGERPRINT_DIGITS = 16;

    private final SweepStudy study;
    private final SweepModel model;
    private final List<FactorScale> scales;
    private final double[][] cube;
    private final List<SweepPoint> points = new ArrayList<>();

    private SweepPlan(SweepStudy study) {
        this.study = study;
        model = study.newModel();
        scales = study.factors().stream().map(f -> FactorScale.of(f, model)).toList();
        cube = study.design()
                .design(study.factors())
                .map(design -> design.points())
                .orElse(new double[0][]);
        List<String> keys = keys();
        if (cube.length == 0) {
            study.design().points().forEach(values -> points.add(new SweepPoint(points.size(), keys, values)));
        }
        for (double[] u : cube) {
            List<String> values = new ArrayList<>();
            for (int f = 0; f < u.length; f++) {
                values.add(scales.get(f).text(u[f]));
            }
            points.add(new SweepPoint(points.size(), keys, values));
        }
    }

    /** The plan of a study. */
    public static SweepPlan of(SweepStudy study) {
        return new SweepPlan(study);
    }

    public SweepStudy study() {
        return study;
    }

    /** Evaluates the points of this plan. */
    public SweepModel model() {
        return model;
    }

    /** The runs, in order. */
    public List<SweepPoint> points() {
        return Collections.unmodifiableList(points);
    }

    public int size() {
        return points.size();
    }

    /**
     * Tells plans apart whose runs of the same index differ: a hash of the factors, all points and what else decides
     * the results. Bodies and recordings count by their names, not by where they lie or what is in them.
     */
    public String fingerprint() {
        String hash = Hashes.sha256((study.computed() + keys()).getBytes(StandardCharsets.UTF_8));
        for (SweepPoint point : points) {
            StringBuilder text = new StringBuilder(hash);
            for (int f = 0; f < point.values().size(); f++) {
                text.append('\n')
                        .append(SweepStudy.withoutFolder(
                                point.keys().get(f), point.values().get(f)));
            }
            hash = Hashes.sha256(text.toString().getBytes(StandardCharsets.UTF_8));
        }
        return hash.substring(0, FINGERPRINT_DIGITS);
    }

    private List<String> keys() {
        return study.factors().stream().map(Factor::key).toList();
    }

    /** The factors and their distributions. */
    public List<FactorScale> scales() {
        return scales;
    }

    /**
     * Changes of the factors from each point to the next as shares of their ranges, 1 or -1 between listed names; none
     * at the first point. Empty for a list.
     */
    public Optional<double[][]> changes() {
        if (cube.length == 0) {
            return Optional.empty();
        }
        double[][] changes = new double[cube.length][scales.size()];
        for (int p = 1; p < cube.length; p++) {
            for (int f = 0; f < scales.size(); f++) {
                String from = points.get(p - 1).values().get(f);
                String to = points.get(p).values().get(f);
                changes[p][f] = scales.get(f).change(from, to, cube[p][f] - cube[p - 1][f]);
            }
        }
        return Optional.of(changes);
    }

    /** Values of a factor at all points, as numbers. */
    public double[] numbers(int factor) {
        return points.stream()
                .mapToDouble(point -> scales.get(factor).number(point.values().get(factor)))
                .toArray();
    }
}
