package org.phrenic.fit;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.phrenic.anatomy.Thorax;
import org.phrenic.file.Hashes;
import org.phrenic.fit.search.FitParameter;
import org.phrenic.fit.search.FitSearch;
import org.phrenic.scenario.Scenario;

/**
 * Inputs of a fit.
 *
 * @param base scenario with body, resolution and all settings that are not fitted
 * @param thorax the body at end-expiration
 * @param targets parts of the body at the second breath level; at least one must have a positive weight
 * @param parameters parameters to fit
 */
public record FitSetup(
        Scenario base, Thorax thorax, List<FitTarget> targets, List<FitParameter> parameters, Options options) {
    /**
     * Options of a fit.
     *
     * @param half part of every surface that is fitted; the rest is only reported
     * @param alignment how the targets were aligned with the axes of the body, as a sentence
     * @param threads number of bodies simulated in parallel; the result does not depend on it
     * @param landmarks pairs of points inside the lungs to report on
     * @param sensitivity whether the effect of each parameter near the fitted values is reported
     */
    public record Options(
            FitHalf half,
            String alignment,
            FitSearch.Settings search,
            int threads,
            boolean sensitivity,
            Optional<Landmarks> landmarks) {
        /** Options without landmarks. */
        public Options(FitHalf half, String alignment, FitSearch.Settings search, int threads, boolean sensitivity) {
            this(half, alignment, search, threads, sensitivity, Optional.empty());
        }

        /** Options for targets that are already aligned with the body, without a held-out half. */
        public Options(FitSearch.Settings search, int threads, boolean sensitivity) {
            this(FitHalf.ALL, TargetAlignment.NONE.sentence(), search, threads, sensitivity);
        }
    }

    public FitSetup {
        targets = List.copyOf(targets);
        parameters = List.copyOf(parameters);
        if (targets.stream().noneMatch(t -> t.weight() > 0)) {
            throw new IllegalArgumentException("fit: found no target with a weight, expected one to fit to");
        }
        if (parameters.isEmpty()) {
            throw new IllegalArgumentException("fit: found no parameter, expected one to tune");
        }
    }

    /** Population size: points per generation. */
    int populationSize() {
        return options.search.population(parameters.size());
    }

    /** Hash of all inputs that affect the values of the search. It identifies the journal of a fit. */
    String fingerprint() {
        StringBuilder text = new StringBuilder();
        base.toMap().forEach((key, value) -> {
            // Zero gravity is omitted so that journals written without a gravity setting remain valid.
            boolean absent = key.startsWith("gravity_") && Double.valueOf(0).equals(value);
            if (!key.equals("threads") && !key.equals("name") && !absent) {
                text.append(key).append('=').append(value).append('\n');
            }
        });
        parameters.forEach(p -> text.append(text(p) + "\n"));
        text.append(options.half + " " + options.search.seed() + " " + populationSize() + " " + options.search.sigma()
                + " retries; compared at " + InspiratoryHold.searchedAtS(base));
        List<double[]> arrays = new ArrayList<>();
        for (FitTarget target : targets) {
            text.append("\n" + target.name() + " " + target.part() + " " + target.weight());
            arrays.add(target.from());
            arrays.add(target.to());
            arrays.add(target.isPointPairs() ? new double[0] : target.surface().positions());
        }
        thorax.structures().forEach(structure -> arrays.add(structure.mesh().positions()));
        arrays.add(text.chars().asDoubleStream().toArray());
        return Hashes.sha256(arrays.toArray(double[][]::new)).substring(0, 12);
    }

    /** Text of a parameter in the fingerprint: its key in capitals, without unit. Part of the journal format. */
    static String text(FitParameter p) {
        String name =
                switch (p.parameter().key()) {
                    case "tendon_stiffness_ratio" -> "TENDON_RATIO";
                    case "action_line_radius_mm" -> "ACTION_RADIUS";
                    default ->
                        p.parameter()
                                .key()
                                .replaceFirst("_(n_per_m|kg_per_m2|ns_per_m|per_s|per_min|kpa|mm|mn|kg)$", "")
                                .toUpperCase(Locale.ROOT);
                };
        return "FitParameter[parameter=" + name + ", minimum=" + p.minimum() + ", maximum=" + p.maximum() + ", start="
                + p.start() + "] " + p.relativeSigma();
    }
}
