package org.phrenic.fit;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.phrenic.anatomy.Thorax;
import org.phrenic.engine.ParticleSystem;
import org.phrenic.file.Hashes;
import org.phrenic.file.ProgramBuild;
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
    /** The program that computes a fit, such as {@code phrenic 0.1.0 build 0123456789ab}. */
    static final String PROGRAM = ProgramBuild.program(
            Set.of("access", "cli", "cluster", "scene", "study", "ui"),
            FitSetup.class,
            Scenario.class,
            Hashes.class,
            ParticleSystem.class);

    private static final int FINGERPRINT_DIGITS = 12;

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
        StringBuilder text = new StringBuilder(thorax.content());
        base.toMap().forEach((key, value) -> {
            if (!key.equals("threads") && !key.equals("name")) {
                text.append('\n').append(key).append('=').append(value);
            }
        });
        parameters.forEach(p -> text.append("\n" + p.parameter().key() + ' ' + p.minimum() + ' ' + p.maximum() + ' '
                + p.start() + ' ' + p.relativeSigma()));
        text.append("\n" + options.half + ' ' + options.search.seed() + ' ' + populationSize() + ' '
                + options.search.sigma() + ' ' + InspiratoryHold.searchedAtS(base));
        targets.forEach(target -> text.append('\n').append(target.content()));
        return Hashes.sha256(text.toString().getBytes(StandardCharsets.UTF_8)).substring(0, FINGERPRINT_DIGITS);
    }
}
