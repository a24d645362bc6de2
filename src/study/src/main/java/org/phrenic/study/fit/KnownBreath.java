package org.phrenic.study.fit;

import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import org.phrenic.anatomy.Thorax;
import org.phrenic.engine.integrator.DivergenceException;
import org.phrenic.file.BadInputException;
import org.phrenic.file.Numbers;
import org.phrenic.fit.Fit;
import org.phrenic.fit.FitPart;
import org.phrenic.fit.FitProgress;
import org.phrenic.fit.FitResult;
import org.phrenic.fit.FitSetup;
import org.phrenic.fit.FitTarget;
import org.phrenic.fit.GroundTruth;
import org.phrenic.fit.search.FitParameter;
import org.phrenic.fit.search.FitSearch;
import org.phrenic.fit.search.ForeignJournalException;
import org.phrenic.scenario.Scenario;
import org.phrenic.study.body.BodyCase;

/**
 * A body that breathes with settings which the fit does not know, and the fit of its lungs.
 *
 * @param body name of the body
 * @param hidden settings of the known breath
 * @param result the fit; empty if it ended without one
 * @param failure why there is no result; empty if there is one
 */
public record KnownBreath(String body, List<String> hidden, Optional<FitResult> result, String failure) {
    private static final double NOISE_MM = 1;
    /** Drives of the attempts at the known breath, relative to what was drawn. */
    private static final double[] DRIVES = {1, 0.7, 0.4};

    /**
     * Simulates a known breath of a body and fits to its lungs. The settings are drawn at random: activation 0.4 to
     * 0.75, rotation of the ribs 0.5 to 1.3, left over right 0.8 to 1.3, front over back 0.7 to 1.4.
     *
     * @param base scenario with the resolution
     * @param seed of the settings and of the noise
     * @throws ForeignJournalException if the folder has the journal of another study
     */
    public static KnownBreath of(
            BodyCase body,
            Scenario base,
            long seed,
            FitSearch.Settings search,
            int threads,
            Path folder,
            FitProgress progress) {
        List<String> hidden = List.of();
        try {
            Thorax thorax = body.thorax().get();
            GroundTruth truth = null;
            String diverged = "";
            for (int attempt = 0; attempt < DRIVES.length && truth == null; attempt++) {
                hidden = hiddenSettings(seed, DRIVES[attempt]);
                try {
                    truth = GroundTruth.of(thorax, settings(base), hidden, lungs(), NOISE_MM, seed);
                } catch (DivergenceException e) {
                    diverged = e.getMessage();
                }
            }
            if (truth == null) {
                return new KnownBreath(body.name(), hidden, Optional.empty(), "the known breath: " + diverged);
            }
            FitSetup setup = new FitSetup(
                    base,
                    thorax,
                    FitTarget.withBases(truth.targets()),
                    FitParameter.defaults(base),
                    new FitSetup.Options(search, threads, false));
            FitResult result = Fit.run(setup, folder.resolve(body.name() + ".csv"), progress);
            return new KnownBreath(body.name(), hidden, Optional.of(result), "");
        } catch (ForeignJournalException ofAll) {
            throw ofAll;
        } catch (BadInputException | DivergenceException | IllegalArgumentException | UncheckedIOException e) {
            return new KnownBreath(body.name(), hidden, Optional.empty(), e.getMessage());
        }
    }

    private static List<FitPart> lungs() {
        return List.of(FitPart.LUNG_RIGHT, FitPart.LUNG_LEFT);
    }

    private static List<String> settings(Scenario base) {
        List<String> list = new ArrayList<>();
        list.add("anatomy=" + base.anatomy());
        list.add("resolution=" + base.toMap().get("resolution"));
        return list;
    }

    /** Settings of a known breath; seeds that follow each other give settings that are independent. */
    static List<String> hiddenSettings(long seed, double drive) {
        SplittableRandom random = new SplittableRandom(seed);
        return List.of(
                setting("muscle_activation", drive * random.nextDouble(0.4, 0.75)),
                setting("rib_rotation", drive * random.nextDouble(0.5, 1.3)),
                setting("left_over_right", random.nextDouble(0.8, 1.3)),
                setting("front_over_back", random.nextDouble(0.7, 1.4)));
    }

    private static String setting(String key, double value) {
        return key + "=" + Numbers.format("%.3f", value);
    }
}
