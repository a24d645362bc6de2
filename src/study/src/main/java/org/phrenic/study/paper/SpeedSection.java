package org.phrenic.study.paper;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.phrenic.anatomy.Resolution;
import org.phrenic.document.report.ReportDocument;
import org.phrenic.document.report.ReportDocument.Column;
import org.phrenic.study.PaperScenarios;
import org.phrenic.study.paper.Claim.Verdict;
import org.phrenic.study.speed.SpeedCase;
import org.phrenic.study.speed.SpeedTable;

/** Table 1 of the paper and what its discussion makes of it. */
final class SpeedSection {
    private static final SpeedTable PRINTED = SpeedTable.published();
    /** "Slightly slower": at most so many per cent. */
    private static final double SLIGHTLY_PERCENT = 10;
    /** Linear: the exponent is one, give or take this. */
    private static final double LINEAR = 0.25;

    private final Reproduction found;
    private final SpeedTable ours;

    SpeedSection(Reproduction found) {
        this.found = found;
        ours = found.speed();
    }

    void add(ReportDocument report) {
        report.section("Table 1: iterations a second");
        List<List<String>> rows = new ArrayList<>();
        for (Resolution resolution : PRINTED.resolutions()) {
            String name = resolution.name().toLowerCase(Locale.ROOT);
            rows.add(List.of(name.substring(0, 1).toUpperCase(Locale.ROOT) + name.substring(1) + " resolution"));
            for (SpeedCase forces : SpeedCase.values()) {
                rows.add(row(PRINTED.row(resolution, forces)));
            }
        }
        report.table(
                "Iterations a second on the virtual anatomy model.",
                List.of(
                        Column.text("forces"),
                        Column.number("vertices, paper"),
                        Column.number("paper"),
                        Column.number("vertices, here"),
                        Column.number("here"),
                        Column.number("times the paper")),
                rows);
        report.paragraph("Here: the paper's material and scheme (midpoint Runge-Kutta, two evaluations of all forces an"
                + " iteration) on one thread, in a step of 0.5 ms that is stable without being split; the median of five"
                + " trials, as the paper took five, in processor time, the four cases of a resolution in turn. The paper:"
                + " a dual-core processor of 2.4 GHz, Java 1.6, Java 3D, 2008. Newer processors are a part"
                + " of the factor; the rest is flat arrays in place of objects, and blocks of nodes that stay in the"
                + " cache.");
        if (found.quick()) {
            report.remark("A quick reproduction: low resolution alone, trials of a fiftieth of a second. The figures of"
                    + " speed are worth little.");
        }
        report.section("The discussion: speed");
        Claim.table(report, "", claims());
    }

    private List<String> row(SpeedTable.Row printed) {
        boolean measured = ours.resolutions().contains(printed.resolution());
        String vertices = "-";
        String perS = "-";
        String times = "-";
        if (measured) {
            SpeedTable.Row row = ours.row(printed.resolution(), printed.forces());
            vertices = grouped(row.vertices());
            perS = grouped(row.stepsPerS());
            times = grouped(row.stepsPerS() / printed.stepsPerS());
        }
        return List.of(
                printed.forces().label(),
                grouped(printed.vertices()),
                String.format(Locale.ROOT, "%.2f", printed.stepsPerS()),
                vertices,
                perS,
                times);
    }

    static String grouped(double value) {
        return String.format(Locale.ROOT, "%,.0f", value);
    }

    List<Claim> claims() {
        return List.of(tensegrity(), ribs(), linear(), realTime());
    }

    private static String percent(double[] leastMeanGreatest) {
        return String.format(
                Locale.ROOT,
                "%+.1f %% of time (%+.1f to %+.1f)",
                leastMeanGreatest[1],
                leastMeanGreatest[0],
                leastMeanGreatest[2]);
    }

    private Claim tensegrity() {
        double[] here = ours.overheadRange(SpeedCase.HETEROGENEOUS, SpeedCase.HOMOGENEOUS);
        return new Claim(
                "The tensegrity constraint makes the simulation slightly slower",
                percent(PRINTED.overheadRange(SpeedCase.HETEROGENEOUS, SpeedCase.HOMOGENEOUS)),
                percent(here),
                Verdict.agrees(here[1] <= SLIGHTLY_PERCENT),
                "Slightly: at most 10 % on the mean of the resolutions. Hundreds of links among tens of thousands of"
                        + " springs cost about as little as the scatter of the trials.");
    }

    private Claim ribs() {
        double[] here = ours.overheadRange(SpeedCase.HETEROGENEOUS, SpeedCase.MUSCLE_ONLY);
        double[] printed = PRINTED.overheadRange(SpeedCase.HETEROGENEOUS, SpeedCase.MUSCLE_ONLY);
        return new Claim(
                "Rib kinematics makes a considerable difference to the speed (large equations each iteration)",
                percent(printed),
                percent(here),
                Verdict.agrees(here[1] >= printed[0]),
                "Considerable: on the mean at least the least of the paper's. Here the axes are fixed and an iteration"
                        + " works out one small matrix a bone; what hangs on bone is carried on at its speed and taken"
                        + " anew every 20 ms.");
    }

    private Claim linear() {
        double printed = PRINTED.exponent(SpeedCase.HETEROGENEOUS).orElseThrow();
        String what = "Time of computation is linear in the number of vertices";
        String paper = String.format(Locale.ROOT, "vertices to the power of %.2f", printed);
        if (ours.exponent(SpeedCase.HETEROGENEOUS).isEmpty()) {
            return Claim.notMeasured(what, paper);
        }
        double here = ours.exponent(SpeedCase.HETEROGENEOUS).getAsDouble();
        return new Claim(
                what,
                paper,
                String.format(Locale.ROOT, "vertices to the power of %.2f", here),
                Verdict.agrees(Math.abs(here - 1) <= LINEAR),
                "Least squares of the logarithms over three resolutions; linear: 1, give or take 0.25. The paper's own"
                        + " figures rise somewhat slower than its vertices.");
    }

    private Claim realTime() {
        Resolution finest = ours.resolutions().get(0);
        double printed = PRINTED.row(finest, SpeedCase.HETEROGENEOUS).stepsPerS() * PaperScenarios.STEP_S;
        return new Claim(
                "Runs in real time",
                String.format(Locale.ROOT, "steps of 0.01 s: %.2f times real time", printed),
                String.format(Locale.ROOT, "%.1f times real time", found.realTimeFactor()),
                Verdict.agrees(found.realTimeFactor() >= 1),
                String.format(
                        Locale.ROOT,
                        "At least 1. The paper means that a picture follows in a tenth of a second; its simulated time"
                                + " passed %.0f times slower than real time. Here: its material and step on one thread,"
                                + " velocity Verlet, %s vertices. Its own scheme would need steps of %.1f ms.",
                        1 / printed,
                        grouped(ours.row(finest, SpeedCase.HETEROGENEOUS).vertices()),
                        1000 * PaperScenarios.STEP_S / found.publishedModel().rk2Substeps()));
    }
}
