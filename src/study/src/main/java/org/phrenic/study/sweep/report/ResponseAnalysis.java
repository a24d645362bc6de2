package org.phrenic.study.sweep.report;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.phrenic.study.sweep.DesignSpec;
import org.phrenic.study.sweep.SweepPlan;
import org.phrenic.study.sweep.SweepResults;
import org.phrenic.study.sweep.index.Bootstrap;
import org.phrenic.study.sweep.index.Estimate;
import org.phrenic.study.sweep.index.MorrisEffects;
import org.phrenic.study.sweep.index.Quantiles;
import org.phrenic.study.sweep.index.ResponseCurve;
import org.phrenic.study.sweep.index.SobolIndices;

/**
 * Statistics of one response over the completed runs.
 *
 * @param name of the response
 * @param values at all points; NaN for a run that failed or is missing
 * @param curves one per factor
 * @param sobol indices, for Saltelli's sampling
 * @param morris effects, for Morris trajectories
 */
record ResponseAnalysis(
        String name,
        double[] values,
        List<ResponseCurve> curves,
        Optional<SobolIndices> sobol,
        Optional<MorrisEffects> morris) {
    private static final double[] SHARES = {0, 0.025, 0.5, 0.975, 1};
    private static final double MOST_WORK = 4e7;
    private static final int LEAST_REPLICATES = 100;

    static ResponseAnalysis of(SweepResults results, int response) {
        SweepPlan plan = results.plan();
        double[] values = results.response(response);
        int factors = plan.scales().size();
        List<ResponseCurve> curves = new ArrayList<>();
        for (int f = 0; f < factors; f++) {
            curves.add(ResponseCurve.of(plan.numbers(f), values));
        }
        DesignSpec.Kind kind = plan.study().design().kind();
        int replicates = (int)
                Math.max(LEAST_REPLICATES, Math.min(Bootstrap.USUAL.replicates(), MOST_WORK / values.length / factors));
        Bootstrap bootstrap = new Bootstrap(replicates, Bootstrap.USUAL.seed());
        return new ResponseAnalysis(
                plan.model().responses().get(response),
                values,
                curves,
                kind == DesignSpec.Kind.SOBOL
                        ? Optional.of(SobolIndices.of(values, factors, bootstrap))
                        : Optional.empty(),
                kind == DesignSpec.Kind.MORRIS
                        ? Optional.of(MorrisEffects.of(plan.changes().orElseThrow(), values, bootstrap))
                        : Optional.empty());
    }

    double mean() {
        return Arrays.stream(values).filter(Double::isFinite).average().orElse(Double.NaN);
    }

    double deviation() {
        double mean = mean();
        double[] finite = Arrays.stream(values).filter(Double::isFinite).toArray();
        double squares = Arrays.stream(finite).map(v -> (v - mean) * (v - mean)).sum();
        return finite.length < 2 ? Double.NaN : Math.sqrt(squares / (finite.length - 1));
    }

    /** Least value, 2.5 % quantile, median, 97.5 % quantile, greatest value. */
    double[] quantiles() {
        return Quantiles.of(values, SHARES);
    }

    /** The statistics for JSON. */
    Map<String, Object> toMap(List<String> factors) {
        Map<String, Object> map = new LinkedHashMap<>();
        double[] q = quantiles();
        put(map, "mean", mean());
        put(map, "sd", deviation());
        put(map, "min", q[0]);
        put(map, "q025", q[1]);
        put(map, "median", q[2]);
        put(map, "q975", q[3]);
        put(map, "max", q[4]);
        sobol.ifPresent(s -> {
            map.put("samples", s.samples());
            map.put("first_order", named(factors, s.first()));
            map.put("total", named(factors, s.total()));
        });
        morris.ifPresent(m -> {
            map.put("mu", named(factors, m.mu()));
            map.put("mu_star", named(factors, m.muStar()));
            map.put("sigma", named(factors, m.sigma()));
        });
        return map;
    }

    private static void put(Map<String, Object> map, String key, double value) {
        if (Double.isFinite(value)) {
            map.put(key, value);
        }
    }

    private static Map<String, Object> named(List<String> factors, List<Estimate> estimates) {
        Map<String, Object> map = new LinkedHashMap<>();
        for (int f = 0; f < estimates.size(); f++) {
            Map<String, Object> one = new LinkedHashMap<>();
            put(one, "value", estimates.get(f).value());
            put(one, "low", estimates.get(f).low());
            put(one, "high", estimates.get(f).high());
            map.put(factors.get(f), one);
        }
        return map;
    }
}
