package org.phrenic.study.regression;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.Thorax;
import org.phrenic.anatomy.virtual.VirtualThorax;
import org.phrenic.document.YamlWriter;
import org.phrenic.engine.parallel.ProgressListener;
import org.phrenic.file.BadInputException;
import org.phrenic.model.organ.OrganSettings;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.observe.Observation;

/** What the program gives is what it gave; small changes, swapped sides and lost numbers are each caught. */
@Execution(ExecutionMode.CONCURRENT)
class RegressionTest {
    /** When the small scene is looked at first, s; twice as late again. */
    private static final double SMALL_S = 0.25;

    /** Vertices of its mesh: nothing is asserted of its shape. */
    private static final int SMALL_VERTICES = 2000;

    private static final ProgressListener SILENT = (count, total, what) -> {};

    /** What the small scene gives. Where it cannot be computed, the tests that need none of it go on. */
    private static final class Computed {
        static final RegressionReference ONCE = of(null, small()).compute(small());
    }

    @TempDir
    Path folder;

    private static RegressionScene scene(String name) {
        return Regression.shippedList().stream()
                .filter(s -> s.name().equals(name))
                .findFirst()
                .orElseThrow();
    }

    private static Thorax body(Scenario scenario) {
        return VirtualThorax.ofPreset(
                scenario.anatomy().substring("virtual/".length()), OrganSettings.budget(scenario));
    }

    private static Regression of(Path folder, RegressionScene scene) {
        return new Regression(folder, List.of(scene), List.of(), RegressionTest::body);
    }

    /** A scene that takes a moment. */
    private static RegressionScene small() {
        return new RegressionScene(
                "small",
                List.of("mesh_vertices=" + SMALL_VERTICES, "material=paper", "lungs=off", "sternum=off", "liver=false"),
                List.of(),
                new double[] {SMALL_S, 2 * SMALL_S},
                0.005,
                0.001);
    }

    /** What the small scene gives, computed once, in numbers of one's own. */
    private static RegressionReference computed() {
        RegressionReference once = Computed.ONCE;
        return new RegressionReference(
                once.specification(),
                once.nodeCount(),
                once.nodes().clone(),
                once.frames().stream()
                        .map(frame -> new RegressionReference.Frame(
                                frame.timeS(),
                                frame.positions().clone(),
                                frame.observables().clone()))
                        .toList(),
                once.unknown());
    }

    /** The regression itself: what every build runs. */
    @Test
    void everySceneGivesWhatItGave() {
        assertThat(new Regression(null).check(List.of(), SILENT))
                .hasSizeGreaterThanOrEqualTo(8)
                .allSatisfy(c -> assertThat(c.passes())
                        .as(c.scene() + ": " + c.sentence()
                                + " (if this is meant: phrenic regress --write-references data/regression)")
                        .isTrue());
    }

    @ParameterizedTest
    @CsvSource({
        "quiet, muscle_stiffness_n_per_m=303",
        "paper, spring_stiffness_n_per_m=15.15",
        "implicit, muscle_stiffness_n_per_m=297"
    })
    void onePerCentOfStiffnessIsCaught(String name, String other) {
        RegressionScene scene = scene(name);
        List<String> settings = new ArrayList<>(scene.settings());
        settings.add(other);
        RegressionScene changed = new RegressionScene(
                name, settings, scene.changes(), scene.timesS(), scene.toleranceMm(), scene.observableTolerance());
        Regression regression = of(null, scene);
        RegressionComparison comparison =
                RegressionComparison.of(scene, regression.reference(scene), regression.compute(changed));
        assertThat(comparison.passes()).isFalse();
        // Not by a hair: ten times the tolerance.
        assertThat(comparison.worstMm()).isGreaterThan(10 * scene.toleranceMm());
        assertThat(comparison.worstRelativeError())
                .as(comparison.worstObservable())
                .isGreaterThan(2 * scene.observableTolerance());
        assertThat(comparison.sentence())
                .contains("node " + comparison.worstNode())
                .contains("the tolerance is " + scene.toleranceMm() + " mm");
    }

    /** Scenes share a body only where it is meshed alike. */
    @Test
    void aSceneOnAnotherMeshHasABodyOfItsOwn() {
        RegressionScene scene = small();
        double[] oneStep = {0.005};
        RegressionScene first = new RegressionScene(
                "small", scene.settings(), scene.changes(), oneStep, scene.toleranceMm(), scene.observableTolerance());
        List<String> settings = new ArrayList<>(scene.settings());
        settings.add("mesh_vertices=3000");
        RegressionScene second = new RegressionScene(
                "other", settings, scene.changes(), oneStep, scene.toleranceMm(), scene.observableTolerance());
        List<Integer> meshed = new ArrayList<>();
        Regression regression = new Regression(folder, List.of(first, second), List.of(), s -> {
            meshed.add(OrganSettings.budget(s).vertices());
            return body(s);
        });
        regression.write(List.of(), SILENT);
        assertThat(meshed).containsExactly(SMALL_VERTICES, 3000);
    }

    @Test
    void aRibWhoseSidesAreSwappedIsCaught() {
        RegressionScene scene = scene("quiet");
        Regression swapped = new Regression(null, List.of(scene), List.of(), s -> withSidesSwapped(body(s), 8));
        assertThat(swapped.check(List.of(), SILENT))
                .singleElement()
                .satisfies(c -> assertThat(c.passes()).as(c.toString()).isFalse());
    }

    /** Left and right of one rib under each other's names. */
    private static Thorax withSidesSwapped(Thorax thorax, int level) {
        List<Structure> structures = thorax.structures().stream()
                .map(s -> s.level() == level && s.name().startsWith("rib_")
                        ? new Structure(
                                s.name().substring(0, s.name().length() - 1) + (s.side() == Side.LEFT ? "R" : "L"),
                                s.kind(),
                                level,
                                s.side() == Side.LEFT ? Side.RIGHT : Side.LEFT,
                                s.mesh())
                        : s)
                .toList();
        assertThat(structures).isNotEqualTo(thorax.structures());
        return new Thorax(thorax.name(), structures, thorax.notes());
    }

    @Test
    void whatIsNoNumberIsCaughtWhereverItIs() {
        RegressionScene scene = small();
        RegressionReference right = computed();
        RegressionReference computed = computed();
        assertThat(RegressionComparison.of(scene, right, computed).passes()).isTrue();
        int last = right.frames().get(1).positions().length - 1;
        for (int place : new int[] {0, 1, last / 2, last}) {
            double kept = right.frames().get(0).positions()[place];
            right.frames().get(0).positions()[place] = Double.NaN;
            RegressionComparison lost = RegressionComparison.of(scene, computed, right);
            assertThat(lost.passes()).isFalse();
            assertThat(lost.worstMm()).isNaN();
            assertThat(lost.worstNode()).isEqualTo(right.nodes()[place / 3]);
            assertThat(lost.worstNodeTimeS()).isEqualTo(SMALL_S);
            right.frames().get(0).positions()[place] = kept;
        }
    }

    /** A reference that ends early would hide what comes after it. */
    @Test
    void referencesOfOtherTimesDoNotPass() {
        RegressionScene scene = small();
        RegressionReference whole = computed();
        RegressionReference early = new RegressionReference(
                whole.specification(),
                whole.nodeCount(),
                whole.nodes(),
                whole.frames().subList(0, 1),
                whole.unknown());
        for (RegressionComparison comparison :
                List.of(RegressionComparison.of(scene, early, whole), RegressionComparison.of(scene, whole, early))) {
            assertThat(comparison.passes()).isFalse();
            assertThat(comparison.sentence()).contains("times, the references are of");
        }
    }

    @Test
    void anObservableThatIsNoNumberIsCaught() {
        RegressionScene scene = small();
        RegressionReference right = computed();
        int column = Observation.COLUMNS.indexOf("dome_right_mm");
        RegressionReference lost = computed();
        lost.frames().get(1).observables()[column] = Double.NaN;
        for (RegressionComparison comparison : List.of(
                RegressionComparison.of(scene, right, lost),
                RegressionComparison.of(scene, lost, right),
                RegressionComparison.of(scene, lost, lost))) {
            assertThat(comparison.passes()).isFalse();
            assertThat(comparison.sentence())
                    .contains("dome_right_mm")
                    .contains("NaN")
                    .contains("0.500 s");
        }
    }

    @Test
    void anObservableThatTheSceneLacksIsUnknownInItsReferences() throws IOException {
        RegressionScene scene = small();
        int column = Observation.COLUMNS.indexOf("liver_si_mm");
        assertThat(computed().frames()).allMatch(frame -> Double.isNaN(frame.observables()[column]));
        of(folder, scene).write(List.of(), SILENT);
        Path file = folder.resolve("small.yaml");
        assertThat(file).content().contains("liver_si_mm: unknown");
        assertThat(of(folder, scene).check(List.of(), SILENT)).singleElement().matches(RegressionComparison::passes);
        Files.writeString(file, Files.readString(file).replace("liver_si_mm: unknown", "liver_si_mm: 0.0"));
        assertThat(of(folder, scene).check(List.of(), SILENT)).singleElement().satisfies(c -> {
            assertThat(c.passes()).isFalse();
            assertThat(c.sentence())
                    .startsWith("liver_si_mm: known in the references")
                    .contains("--write-references");
            assertThat(c.worstRelativeError()).isLessThan(scene.observableTolerance());
        });
    }

    @Test
    void anObservableThatTheSceneHasIsNeverUnknownInItsReferences() {
        RegressionReference lost = computed();
        lost.frames().get(1).observables()[Observation.COLUMNS.indexOf("dome_right_mm")] = Double.NaN;
        assertThatThrownBy(() -> YamlWriter.write(folder.resolve("small.yaml"), lost.values()))
                .hasMessageContaining("NaN");
    }

    /** Some millimetres, so that the tolerance is a share of the value. */
    @Test
    void anObservableIsCaughtJustBeyondItsTolerance() {
        RegressionScene scene = small();
        int column = Observation.COLUMNS.indexOf("from_rest_rms_mm");
        for (double share : new double[] {0.9, 1.1}) {
            RegressionReference right = computed();
            RegressionReference off = computed();
            right.frames().get(1).observables()[column] = -8;
            off.frames().get(1).observables()[column] = -8 * (1 + share * scene.observableTolerance());
            assertThat(RegressionComparison.of(scene, right, off).passes())
                    .as("%s of the tolerance", share)
                    .isEqualTo(share < 1);
        }
    }

    /** One number off, one word, one entry less: each is told by its place in the report. */
    @Test
    void aReportThatIsNotWhatItWasIsCaught() {
        RegressionAttempt attempt = Regression.shippedAttempts().get(0);
        Map<String, String> then = Map.of(
                "attempt.hit", "true", "attempt.lateral_error_mm", "1.5", "attempt.events.0.what", "skin puncture");
        assertThat(attempt.compare(then, then).passes()).isTrue();
        Map<String, String> now = new TreeMap<>(then);
        now.put("attempt.lateral_error_mm", "1.5004");
        assertThat(attempt.compare(then, now).passes()).isTrue();
        for (String wrong : List.of("1.503", "NaN", "")) {
            now.put("attempt.lateral_error_mm", wrong);
            assertThat(attempt.compare(then, now).sentence())
                    .contains("attempt.lateral_error_mm is " + wrong)
                    .contains("the reference is 1.5");
        }
        now.putAll(then);
        now.put("attempt.hit", "false");
        assertThat(attempt.compare(then, now).passes()).isFalse();
        now.remove("attempt.hit");
        assertThat(attempt.compare(then, now).sentence()).contains("missing [attempt.hit]");
    }

    /** Those compared before it, and its name, would be lost with an exception. */
    @Test
    void whatCanNoLongerBeDoneIsOffByItsNameAndTheOthersAreCompared() {
        RegressionScene scene = scene("implicit");
        RegressionAttempt attempt = Regression.shippedAttempts().get(0);
        Regression bodiless =
                new Regression(null, List.of(scene), List.of(attempt), s -> without(body(s), "diaphragm"));
        assertThat(bodiless.check(List.of(), SILENT))
                .allSatisfy(c -> {
                    assertThat(c.passes()).isFalse();
                    assertThat(c.sentence()).contains("diaphragm");
                })
                .extracting(RegressionComparison::scene)
                .containsExactly("implicit", attempt.name());
        Regression liverless = new Regression(null, List.of(), List.of(attempt), s -> without(body(s), "liver"));
        assertThat(liverless.check(List.of(), SILENT)).singleElement().satisfies(c -> {
            assertThat(c.passes()).isFalse();
            assertThat(c.sentence()).contains("liver");
        });
    }

    private static Thorax without(Thorax thorax, String name) {
        return new Thorax(
                thorax.name(),
                thorax.structures().stream()
                        .filter(structure -> !structure.name().equals(name))
                        .toList(),
                thorax.notes());
    }

    @Test
    void aPositionLostOnTheWayIsCaughtByTheRun() {
        RegressionScene scene = small();
        of(folder, scene).write(List.of(), SILENT);
        Regression broken = new Regression(folder, List.of(scene), List.of(), RegressionTest::body) {
            @Override
            void prepare(org.phrenic.simulation.Simulation simulation) {
                simulation.system().positions()[7] = Double.NaN;
            }
        };
        assertThat(broken.check(List.of(), SILENT)).singleElement().satisfies(c -> {
            assertThat(c.passes()).isFalse();
            assertThat(c.sentence()).contains("is not a finite number");
        });
    }

    @Test
    void writtenReferencesAreTheSameBytesAgainAndHold() throws IOException {
        RegressionScene scene = small();
        of(folder, scene).write(List.of(), SILENT);
        byte[] once = Files.readAllBytes(folder.resolve("small.yaml"));
        of(folder, scene).write(List.of(), SILENT);
        assertThat(folder.resolve("small.yaml")).hasBinaryContent(once);
        assertThat(of(folder, scene).check(List.of(), SILENT)).singleElement().satisfies(c -> {
            assertThat(c.passes()).isTrue();
            // What is written is in whole micrometres: half of one on each axis.
            assertThat(c.worstMm()).isLessThan(0.5e-3 * Math.sqrt(3) + 1e-9);
        });
    }

    @Test
    void shippedReferencesAreSmall() throws IOException {
        try (var files = Files.list(Path.of("data/regression"))) {
            long bytes = 0;
            for (Path file : files.toList()) {
                bytes += Files.size(file);
            }
            assertThat(bytes).isLessThan(200_000);
        }
    }

    @Test
    void badReferencesAreToldInOneSentence() throws IOException {
        RegressionScene scene = small();
        assertThatThrownBy(() -> of(folder, scene).check(List.of(), SILENT))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("small.yaml");
        of(folder, scene).write(List.of(), SILENT);
        Path file = folder.resolve("small.yaml");
        String whole = Files.readString(file);
        // Cut at any place: half a number, half a frame, half a list of observables.
        for (int parts = 1; parts < 12; parts++) {
            Files.writeString(file, whole.substring(0, whole.length() * parts / 12));
            assertThatThrownBy(() -> of(folder, scene).check(List.of(), SILENT))
                    .as(parts + " twelfths")
                    .isInstanceOf(BadInputException.class)
                    .hasMessageContaining("small.yaml")
                    .hasMessageNotContaining("\n");
        }
        // 2^32 more than a node of the scene.
        Files.writeString(file, whole.replaceFirst("(?m)^(?<key>nodes: \\D?)\\d+", "${key}4294967297"));
        assertThatThrownBy(() -> of(folder, scene).check(List.of(), SILENT))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("found node 4294967297, expected 0 to ");
        Files.writeString(file, whole.replaceFirst("nodes_in_all: \\d+", "nodes_in_all: 4294967297"));
        assertThatThrownBy(() -> of(folder, scene).check(List.of(), SILENT))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("nodes_in_all");
        Files.writeString(file, whole.replace("material=paper", "material=physical"));
        assertThatThrownBy(() -> of(folder, scene).check(List.of(), SILENT))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("another scene")
                .hasMessageContaining("--write-references");
    }
}
