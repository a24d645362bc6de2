package org.phrenic.study.paper;

import static org.phrenic.file.Numbers.format;
import static org.phrenic.study.ReportNumbers.grouped;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;
import org.phrenic.anatomy.Resolution;
import org.phrenic.document.report.ReportDocument;
import org.phrenic.study.PaperScenarios;
import org.phrenic.study.ReportNumbers;
import org.phrenic.study.paper.Claim.Verdict;
import org.phrenic.study.speed.SpeedCase;
import org.phrenic.study.speed.SpeedTable;

/** Table 1 of the paper and its statements about speed. */
final class SpeedSection {
    private static final SpeedTable PUBLISHED = SpeedTable.published();
    /** "Slightly slower": largest increase of the time per iteration, per cent. */
    private static final double SLIGHTLY_PERCENT = 10;
    /** Tolerance for an exponent of one. */
    private static final double EXPONENT_TOLERANCE = 0.25;

    private final Reproduction reproduction;
    private final SpeedTable ours;

    SpeedSection(Reproduction reproduction) {
        this.reproduction = reproduction;
        ours = reproduction.speed();
    }

    void add(ReportDocument report) {
        report.section("Table 1: iterations a second");
        List<List<String>> rows = new ArrayList<>();
        for (Resolution resolution : PUBLISHED.resolutions()) {
            String name = ReportNumbers.label(resolution);
            rows.add(List.of(name.substring(0, 1).toUpperCase(Locale.ROOT) + name.substring(1) + " resolution"));
            for (SpeedCase forces : SpeedCase.values()) {
                rows.add(row(PUBLISHED.row(resolution, forces)));
            }
        }
        report.table(
                "Iterations a second on the virtual anatomy model.",
                PaperTexts.columns(
                        1, "forces", "vertices, paper", "paper", "vertices, here", "here", "times the paper"),
                rows);
        report.paragraph(PaperTexts.text("speed"));
        if (reproduction.quick()) {
            report.remark(PaperTexts.text("speed-quick"));
        }
        report.section("The discussion: speed");
        Claim.addTable(report, claims());
    }

    private List<String> row(SpeedTable.Row published) {
        List<String> row = new ArrayList<>(List.of(
                published.forces().label(), grouped(published.vertices()), format("%.2f", published.stepsPerS())));
        if (ours.resolutions().contains(published.resolution())) {
            SpeedTable.Row here = ours.row(published.resolution(), published.forces());
            row.add(grouped(here.vertices()));
            row.add(grouped(here.stepsPerS()));
            row.add(grouped(here.stepsPerS() / published.stepsPerS()));
        } else {
            row.addAll(List.of("-", "-", "-"));
        }
        return row;
    }

    private static String percent(double[] range) {
        return format("%+.1f %% of time (%+.1f to %+.1f)", range[1], range[0], range[2]);
    }

    List<Claim> claims() {
        double[] links = ours.overheadRange(SpeedCase.HETEROGENEOUS, SpeedCase.HOMOGENEOUS);
        double[] linksPublished = PUBLISHED.overheadRange(SpeedCase.HETEROGENEOUS, SpeedCase.HOMOGENEOUS);
        double[] ribs = ours.overheadRange(SpeedCase.HETEROGENEOUS, SpeedCase.MUSCLE_ONLY);
        double[] ribsPublished = PUBLISHED.overheadRange(SpeedCase.HETEROGENEOUS, SpeedCase.MUSCLE_ONLY);
        Verdict slightly = Verdict.agrees(links[1] <= SLIGHTLY_PERCENT);
        Verdict considerable = Verdict.agrees(ribs[1] >= ribsPublished[0]);
        return List.of(
                PaperTexts.claim("speed-tensegrity", slightly, percent(links), percent(linksPublished)),
                PaperTexts.claim("speed-ribs", considerable, percent(ribs), percent(ribsPublished)),
                linear(),
                realTime());
    }

    private Claim linear() {
        double exponent = PUBLISHED.exponent(SpeedCase.HETEROGENEOUS).orElseThrow();
        String published = format("%.2f", exponent);
        OptionalDouble here = ours.exponent(SpeedCase.HETEROGENEOUS);
        if (here.isEmpty()) {
            return PaperTexts.notMeasured("speed-linear", published);
        }
        return PaperTexts.claim(
                "speed-linear",
                Verdict.agrees(Math.abs(here.getAsDouble() - 1) <= EXPONENT_TOLERANCE),
                format("vertices to the power of %.2f", here.getAsDouble()),
                published);
    }

    private Claim realTime() {
        Resolution finest = ours.resolutions().get(0);
        double published = PUBLISHED.row(finest, SpeedCase.HETEROGENEOUS).stepsPerS() * PaperScenarios.STEP_S;
        return PaperTexts.claim(
                "real-time",
                Verdict.agrees(reproduction.realTimeFactor() >= 1),
                format("%.1f times real time", reproduction.realTimeFactor()),
                format("%.2f", published),
                format("%.0f", 1 / published),
                grouped(ours.row(finest, SpeedCase.HETEROGENEOUS).vertices()),
                reproduction.publishedModel().rk2Substeps(),
                reproduction.publishedModel().rk2SternumSubsteps());
    }
}
