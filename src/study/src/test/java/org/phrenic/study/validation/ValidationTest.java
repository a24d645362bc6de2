package org.phrenic.study.validation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.phrenic.anatomy.BoxBody;
import org.phrenic.anatomy.SharedThorax;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.document.report.MarkdownPage;
import org.phrenic.engine.parallel.ProgressListener;
import org.phrenic.mesh.io.MeshFiles;
import org.phrenic.scenario.Scenario;
import org.phrenic.study.validation.Finding.Verdict;

/** Breaths held against the table. */
class ValidationTest {
    /** The sheet alone is stepped; a breath of one second is enough to see that numbers come out alike. */
    private static final Scenario FAST = Scenario.defaults()
            .with("resolution=low", "mesh_vertices=3000", "lungs=embedded", "sternum=kinematic", "rate_per_min=60");

    private static ReferenceRange row(String preset, String body, double low, double high, Confidence confidence) {
        return new ReferenceRange(
                "q",
                Optional.of(preset),
                Optional.ofNullable(body),
                List.of("x"),
                Reduction.FALL,
                "",
                Optional.empty(),
                1,
                1,
                low,
                high,
                "mm",
                confidence,
                "someone",
                "",
                "");
    }

    private static Finding judge(ReferenceRange row, String sex) {
        return Validation.judge(List.of(row), Map.of("quiet", SyntheticBreath.breath()), Optional.ofNullable(sex))
                .get(0);
    }

    @Test
    void aRowIsWithinOutOrNotMeasurableAndOnlyAConfidentMissCounts() {
        // The made-up x falls by 20.
        assertThat(judge(row("quiet", null, 15, 25, Confidence.SEEN), null).verdict())
                .isEqualTo(Verdict.WITHIN);
        assertThat(judge(row("quiet", null, 21, 25, Confidence.SEEN), null).isMiss())
                .isTrue();
        assertThat(judge(row("quiet", null, 21, 25, Confidence.CONFIDENT), null).isMiss())
                .isTrue();
        Finding fair = judge(row("quiet", null, 21, 25, Confidence.FAIR), null);
        assertThat(fair.verdict()).isEqualTo(Verdict.OUT);
        assertThat(fair.isMiss()).isFalse();
        assertThat(fair.reason()).isEqualTo("no reason is known yet");
        assertThat(judge(row("deep", null, 15, 25, Confidence.SEEN), null).reason())
                .contains("not asked for");
        assertThat(judge(row("quiet", "female", 15, 25, Confidence.SEEN), "male")
                        .reason())
                .contains("women");
        assertThat(judge(row("quiet", "male", 15, 25, Confidence.SEEN), null).reason())
                .contains("neither");
    }

    @Test
    void theSexIsAWordOfTheBodysName() {
        assertThat(Validation.sex("adult-female")).contains("female");
        assertThat(Validation.sex("male-thorax")).contains("male");
        assertThat(Validation.sex("thorax 7")).isEmpty();
    }

    private static String markdown(Validation validation) {
        return MarkdownPage.format(new ValidationReport(validation).document(List.of("Commit 1")));
    }

    @Test
    void theReportIsTheSameOnAnyNumberOfThreads() {
        List<String> done = Collections.synchronizedList(new ArrayList<>());
        List<String> presets = List.of("quiet", "quiet-supine");
        List<String> bodies = List.of("virtual/adult-male");
        Validation one = Validation.of(
                PhysiologyTable.shipped(), FAST, bodies, presets, 1, (count, total, what) -> done.add(what));
        Validation two = Validation.of(PhysiologyTable.shipped(), FAST, bodies, presets, 2, (c, t, w) -> {});
        String report = markdown(one);
        assertThat(report).isEqualTo(markdown(two)).contains("For research and training only. Not for clinical use.");
        assertThat(new ValidationReport(one).values()).isEqualTo(new ValidationReport(two).values());
        assertThat(done).containsExactly("virtual/adult-male, quiet", "virtual/adult-male, quiet-supine");
        assertThat(one.bodies().get(0).findings())
                .as("what is given a breath has a value unless it is of women")
                .filteredOn(f -> f.range().preset().filter(presets::contains).isPresent())
                .filteredOn(f -> f.range().body().filter("female"::equals).isEmpty())
                .filteredOn(f -> f.range().againstPreset().isEmpty())
                .allMatch(f -> f.verdict() != Verdict.NOT_MEASURABLE, "measured");
    }

    /** Without this a liver and lungs that are not there would be measured to stand still. */
    @Test
    void whatTheSceneLacksIsNotMeasurable() {
        Validation validation = Validation.of(
                PhysiologyTable.shipped(),
                FAST.with("liver=false", "lungs=off"),
                List.of("virtual/adult-male"),
                List.of("quiet"),
                1,
                (count, total, what) -> {});
        assertThat(validation.bodies().get(0).findings())
                .filteredOn(f -> f.range().preset().filter("quiet"::equals).isPresent())
                .filteredOn(f -> f.range().observables().stream().anyMatch(o -> o.matches("(liver|lung)_.*")))
                .hasSizeGreaterThan(3)
                .allMatch(f -> f.verdict() == Verdict.NOT_MEASURABLE)
                .filteredOn(f -> f.range().key().equals("liver_si_quiet"))
                .singleElement()
                .satisfies(f -> assertThat(f.reason()).contains("lacks what it is measured on"));
        assertThat(validation.bodies().get(0).findings())
                .filteredOn(f -> f.range().observables().contains("dome_right_mm"))
                .anyMatch(f -> f.verdict() != Verdict.NOT_MEASURABLE);
    }

    /** What was computed of the others is not lost, and nothing passes for what was not. */
    @Test
    void aBreathThatFailsIsReportedAndTheOthersGoOn(@TempDir Path folder) throws IOException {
        BoxBody.structures().stream()
                .filter(s -> s.kind() != StructureKind.RIB)
                .forEach(s -> MeshFiles.write(folder.resolve(s.name() + ".ply"), s.mesh()));
        Files.writeString(folder.resolve("thorax.yaml"), "axes: LPS\nunits: mm\n");
        List<String> bodies = List.of("virtual/adult-male", folder.toString());
        List<String> notes = new ArrayList<>();
        ProgressListener progress = new ProgressListener() {
            @Override
            public void done(int count, int total, String what) {}

            @Override
            public void note(String sentence) {
                notes.add(sentence);
            }
        };
        Validation validation = Validation.of(PhysiologyTable.shipped(), FAST, bodies, List.of("quiet"), 1, progress);
        assertThat(validation.failures()).singleElement().asString().startsWith(folder + ", quiet: ");
        assertThat(notes).containsAll(validation.failures());
        assertThat(new Validation(validation.table(), FAST, List.of(), validation.failures()).passes())
                .isFalse();
        assertThat(new Validation(validation.table(), FAST, List.of(), List.of()).passes())
                .isTrue();
        assertThat(validation.bodies().get(0).count(Verdict.WITHIN)).isPositive();
        assertThat(validation.bodies().get(1).count(Verdict.WITHIN)).isZero();
        assertThat(validation.bodies().get(1).findings())
                .extracting(Finding::reason)
                .contains("the breath could not be computed", "the preset was not asked for");
        assertThat(markdown(validation)).contains("## Not computed", "- " + folder + ", quiet: ");
        assertThat(new ValidationReport(validation).values()).containsEntry("failures", validation.failures());
    }

    @Test
    void whereEveryBreathFailsTheFirstReasonIsThrown() {
        Scenario refused = FAST.with("integrator=lagged", "damping_rate_per_s=0");
        assertThatThrownBy(() -> Validation.of(
                        PhysiologyTable.shipped(),
                        refused,
                        List.of("virtual/adult-male"),
                        List.of("quiet"),
                        1,
                        (count, total, what) -> {}))
                .hasMessageContaining("lagged grows at every step");
    }

    @Test
    void aRealThoraxBreathesInTheOrderOfPeople() {
        String folder = SharedThorax.path("anatomy/male-thorax").toString();
        Scenario settings =
                Scenario.defaults().with("resolution=low", "lungs=embedded", "sternum=kinematic", "rate_per_min=30");
        Validation validation = Validation.of(
                PhysiologyTable.shipped(), settings, List.of(folder), List.of("quiet"), 2, (c, t, w) -> {});
        assertThat(validation.bodies().get(0).sex()).contains("male");
        assertThat(validation.bodies().get(0).findings())
                .filteredOn(f -> f.range().key().matches("(order_|dome_(right|left)).*"))
                .filteredOn(f -> f.range().preset().filter("quiet"::equals).isPresent())
                .filteredOn(f -> f.range().body().filter("female"::equals).isEmpty())
                .hasSizeGreaterThan(6)
                .allMatch(f -> f.verdict() == Verdict.WITHIN);
    }
}
