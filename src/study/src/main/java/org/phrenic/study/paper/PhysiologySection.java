package org.phrenic.study.paper;

import static org.phrenic.study.ReportNumbers.number;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.phrenic.document.report.ReportDocument;
import org.phrenic.study.paper.Claim.Verdict;
import org.phrenic.study.paper.Reproduction.Run;

/** What the paper's clinical collaborator told of breathing. */
final class PhysiologySection {
    /** Only the domes: the centre goes less than this share of their way. */
    private static final double ONLY = 0.25;
    /** A level is met within half a bone. */
    private static final double LEVEL = 0.5;

    private static final double FOURTH_SPACE = 4.5;
    private static final double FIFTH_RIB = 5;

    private final Reproduction found;

    PhysiologySection(Reproduction found) {
        this.found = found;
    }

    void add(ReportDocument report) {
        report.section("The discussion: physiology");
        report.paragraph(
                "Levels: whole numbers are the middles of bones and grow downward, so 8.5 lies between T8 and T9, and"
                        + " 4.5 is the fourth intercostal space.");
        Claim.table(report, "", claims());
    }

    List<Claim> claims() {
        PaperBreath light = found.breath(Run.LIGHT).orElseThrow();
        return List.of(light(light), deep(light), tendon(), right(light), left(light), dimensions());
    }

    private static Claim light(PaperBreath light) {
        double centre = -light.change("central_tendon_mm");
        return new Claim(
                "Breathing lightly, only the domes descend",
                "said",
                "domes " + number(light.domeDescentMm()) + " mm, central tendon " + number(centre) + " mm",
                Verdict.agrees(centre < ONLY * light.domeDescentMm()),
                "Only: the centre goes less than a quarter of their way.");
    }

    private Claim deep(PaperBreath light) {
        String what = "With a deep breath the domes descend further";
        return found.breath(Run.DEEP)
                .map(deep -> new Claim(
                        what,
                        "said",
                        number(deep.domeDescentMm()) + " mm after " + number(light.domeDescentMm()) + " mm",
                        Verdict.agrees(deep.domeDescentMm() > light.domeDescentMm()),
                        "Mean of both domes."))
                .orElseGet(() -> Claim.notMeasured(what, "said"));
    }

    private Claim tendon() {
        String what = "With a deep breath the central tendon can move from the level of T8 to T9";
        Optional<PaperBreath> deep = found.breath(Run.DEEP);
        if (deep.isEmpty()) {
            return Claim.notMeasured(what, "T8 to T9");
        }
        double from = deep.get().atEndExpiration("central_tendon_vertebra");
        double to = deep.get().atEndInspiration("central_tendon_vertebra");
        return new Claim(
                what,
                "T8 to T9",
                String.format(Locale.ROOT, "T%.1f to T%.1f, by %.1f vertebrae", from, to, to - from),
                Verdict.agrees(Math.abs(from - 8) <= LEVEL && Math.abs(to - 9) <= LEVEL),
                "Met within half a vertebra at both ends. The way is that of the paper; where it begins is given with the"
                        + " generic body, whose tendon lies low in the midline.");
    }

    private static Claim right(PaperBreath light) {
        return level(
                "In full exhale the right dome reaches the 4th intercostal space",
                "4.5",
                light.atEndExpiration("dome_right_rib"),
                FOURTH_SPACE);
    }

    private static Claim left(PaperBreath light) {
        return level(
                "In full exhale the left dome reaches the 5th rib",
                "5",
                light.atEndExpiration("dome_left_rib"),
                FIFTH_RIB);
    }

    private static Claim level(String what, String printed, double here, double wanted) {
        return new Claim(
                what,
                printed,
                String.format(Locale.ROOT, "%.1f at end-expiration", here),
                Verdict.agrees(Math.abs(here - wanted) <= LEVEL),
                "Met within half a rib. Breathing out below end-expiration is not modelled, and would raise the dome"
                        + " further. Measured against the front halves of the ribs in the midclavicular line; the generic"
                        + " body's domes stand high.");
    }

    private Claim dimensions() {
        String what = "Antero-posterior, transverse and vertical dimensions of the thorax increase";
        Optional<PaperBreath> deep = found.breath(Run.DEEP);
        if (deep.isEmpty()) {
            return Claim.notMeasured(what, "shown");
        }
        double ap = deep.get().change("ap_change_mm");
        double across = deep.get().change("transverse_change_mm");
        double vertical = deep.get().domeDescentMm();
        return new Claim(
                what,
                "shown",
                number(ap) + ", " + number(across) + " and " + number(vertical) + " mm",
                Verdict.agrees(ap > 0 && across > 0 && vertical > 0),
                "In a deep breath; vertical: the descent of the domes. The paper calls the transverse motion pump handle;"
                        + " its usual name is bucket handle.");
    }
}
