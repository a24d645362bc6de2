package org.phrenic.study.sweep;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;

/** The runs of a study in the order of its design. The same study gives the same plan. Immutable. */
public final class SweepPlan {
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
        List<String> keys = study.factors().stream().map(Factor::key).toList();
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
