package org.phrenic.study.body;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.document.report.MarkdownPage;
import org.phrenic.scenario.Scenario;

class BodyReportTest {
    private static BreathResult breath(BreathDepth depth, double dome, double returned, OrganCrossing inspired) {
        return new BreathResult(
                depth,
                "",
                new BreathResult.Motion(dome, dome - 1, 10 * dome, returned),
                OrganCrossing.NONE,
                Optional.of(inspired));
    }

    private static BodyCase body(String name) {
        return new BodyCase(name, "as it is", 1, () -> {
            throw new AssertionError("the report loads no body");
        });
    }

    private static final BodyResult GOOD = new BodyResult(
            body("good"),
            "",
            "",
            Optional.empty(),
            Optional.empty(),
            List.of(new SurfaceMiss(StructureKind.RIB, 24, 1.5, 4)),
            List.of(
                    breath(BreathDepth.QUIET, 15, 0.2, OrganCrossing.NONE),
                    breath(BreathDepth.DEEP, 55, 0.3, OrganCrossing.NONE)));

    @Test
    void everyColumnHasItsSideAndItsBreath() {
        BodyReport report = new BodyReport(new BodyStudy(Scenario.defaults(), List.of(GOOD)));
        assertThat(report.table().get(0))
                .startsWith("body", "quiet R mm", "L", "return mm", "deep R mm", "L", "air ml", "return mm");
        assertThat(report.table().get(1)).startsWith("good", "15.0", "14.0", "0.20", "55.0", "54.0", "550", "0.30");
        List<String> lines = report.csv().lines().toList();
        List<String> header = List.of(lines.get(0).split(",", -1));
        List<String> deep = List.of(lines.get(2).split(",", -1));
        assertThat(deep.get(header.indexOf("breath"))).isEqualTo("deep");
        assertThat(List.of("dome_right_mm", "dome_left_mm", "air_ml", "return_rms_mm"))
                .extracting(column -> Double.valueOf(deep.get(header.indexOf(column))))
                .containsExactly(55.0, 54.0, 550.0, 0.3);
    }

    @Test
    void limitsAreHeldForEachBreath() {
        assertThat(GOOD.passes()).isTrue();
        BodyResult bad = new BodyResult(
                body("bad"),
                "",
                "",
                Optional.empty(),
                Optional.empty(),
                List.of(),
                List.of(
                        breath(BreathDepth.QUIET, 7.9, 0.51, OrganCrossing.NONE),
                        breath(BreathDepth.DEEP, 55, Double.NaN, new OrganCrossing(0, 2, 1, 4.5, "spleen"))));
        assertThat(bad.faults())
                .containsExactly(
                        "quiet: domes 7.9 and 6.9 mm",
                        "quiet: returns to 0.51 mm rms",
                        "deep: returns to NaN mm rms",
                        "deep: 3 organ vertices through the diaphragm at full inspiration, spleen by 4.5 mm");
    }

    @Test
    void settingsThatAreNotTheDefaultsAreNamed() {
        BodyReport usual = new BodyReport(new BodyStudy(Scenario.defaults().with("threads=1"), List.of(GOOD)));
        assertThat(MarkdownPage.format(usual.document(List.of()))).contains("from rest, default numbers, medium");
        assertThat(usual.values()).containsEntry("settings", Map.of());
        Scenario other = Scenario.defaults().with("damping_rate_per_s=7", "liver=false", "resolution=low");
        BodyReport given = new BodyReport(new BodyStudy(other, List.of(GOOD)));
        assertThat(MarkdownPage.format(given.document(List.of())))
                .contains("default numbers but for", "liver = false", "damping\\_rate\\_per\\_s = 7");
        assertThat(given.values().get("settings")).isEqualTo(Map.of("damping_rate_per_s", 7.0, "liver", false));
    }

    @Test
    void refusalsAndDivergencesAreToldInTheTableAndTheSummary() {
        BodyResult refused = new BodyResult(
                body("refused"),
                "",
                "no ribs, expected some",
                Optional.empty(),
                Optional.empty(),
                List.of(),
                List.of());
        BodyResult diverged = new BodyResult(
                body("diverged"),
                "",
                "",
                Optional.empty(),
                Optional.empty(),
                List.of(),
                List.of(BreathResult.failed(BreathDepth.QUIET, "it diverged at 0.8 s", OrganCrossing.NONE)));
        BodyReport report = new BodyReport(new BodyStudy(Scenario.defaults(), List.of(GOOD, refused, diverged)));
        assertThat(report.summary())
                .isEqualTo("3 bodies: 1 breathe quietly and deeply to the end, 1 within all limits");
        assertThat(MarkdownPage.format(report.document(List.of("By a test"))))
                .contains(
                        "- By a test",
                        "| good | rib | 24 | 1.50 | 4.00 |",
                        "refused: no ribs, expected some |",
                        "diverges: quiet: it diverged at 0.8 s |");
        List<String> lines = report.csv().lines().toList();
        assertThat(lines).hasSize(4);
        List<String> header = List.of(lines.get(0).split(",", -1));
        List<String> failed = List.of(lines.get(3).split(",", -1));
        assertThat(failed.get(header.indexOf("rest_liver_vertices"))).isEqualTo("0");
        assertThat(failed.get(header.indexOf("inspired_liver_vertices")))
                .as("of a moment that was not reached")
                .isEmpty();
        assertThat(report.values()).containsEntry("passes", false);
    }
}
