package org.phrenic.study.paper;

import static org.phrenic.file.Numbers.format;
import static org.phrenic.study.ReportNumbers.number;

import java.util.List;
import java.util.Optional;
import org.phrenic.document.report.ReportDocument;
import org.phrenic.study.paper.Claim.Verdict;
import org.phrenic.study.paper.Reproduction.Run;

/** Statements on breathing by the paper's clinical collaborator. */
record PhysiologySection(Reproduction reproduction) {
    /** "Only the domes descend": largest ratio of the centre's descent to that of the domes. */
    private static final double MAX_CENTRE_SHARE = 0.25;
    /** Tolerance of a skeletal level: half a bone. */
    private static final double LEVEL_TOLERANCE = 0.5;

    private static final double FOURTH_SPACE = 4.5;
    private static final double FIFTH_RIB = 5;

    void add(ReportDocument report) {
        report.section("The discussion: physiology");
        report.paragraph(PaperTexts.text("levels"));
        Claim.addTable(report, claims());
    }

    List<Claim> claims() {
        return List.of(
                light(),
                deep(),
                tendonLevel(),
                level("right-dome", "dome_right_rib", FOURTH_SPACE),
                level("left-dome", "dome_left_rib", FIFTH_RIB),
                dimensions());
    }

    private Claim light() {
        Optional<PaperBreath> light = reproduction.breath(Run.LIGHT);
        if (light.isEmpty()) {
            return PaperTexts.notMeasured("light");
        }
        double domes = light.get().domeDescentMm();
        double centre = -light.get().change("central_tendon_mm");
        return PaperTexts.claim(
                "light",
                Verdict.agrees(centre < MAX_CENTRE_SHARE * domes),
                "domes " + number(domes) + " mm, central tendon " + number(centre) + " mm");
    }

    private Claim deep() {
        Optional<PaperBreath> light = reproduction.breath(Run.LIGHT);
        Optional<PaperBreath> deep = reproduction.breath(Run.DEEP);
        if (light.isEmpty() || deep.isEmpty()) {
            return PaperTexts.notMeasured("deep");
        }
        double lightMm = light.get().domeDescentMm();
        double deepMm = deep.get().domeDescentMm();
        String measured = number(deepMm) + " mm after " + number(lightMm) + " mm";
        return PaperTexts.claim("deep", Verdict.agrees(deepMm > lightMm), measured);
    }

    private Claim tendonLevel() {
        Optional<PaperBreath> deep = reproduction.breath(Run.DEEP);
        if (deep.isEmpty()) {
            return PaperTexts.notMeasured("tendon-level");
        }
        double from = deep.get().atEndExpiration("central_tendon_vertebra");
        double to = deep.get().atEndInspiration("central_tendon_vertebra");
        return PaperTexts.claim(
                "tendon-level",
                Verdict.agrees(Math.abs(from - 8) <= LEVEL_TOLERANCE && Math.abs(to - 9) <= LEVEL_TOLERANCE),
                format("T%.1f to T%.1f, by %.1f vertebrae", from, to, to - from));
    }

    private Claim level(String key, String level, double expected) {
        Optional<PaperBreath> light = reproduction.breath(Run.LIGHT);
        if (light.isEmpty()) {
            return PaperTexts.notMeasured(key);
        }
        double found = light.get().atEndExpiration(level);
        return PaperTexts.claim(
                key,
                Verdict.agrees(Math.abs(found - expected) <= LEVEL_TOLERANCE),
                format("%.1f at end-expiration", found));
    }

    private Claim dimensions() {
        Optional<PaperBreath> deep = reproduction.breath(Run.DEEP);
        if (deep.isEmpty()) {
            return PaperTexts.notMeasured("dimensions");
        }
        double ap = deep.get().change("ap_change_mm");
        double across = deep.get().change("transverse_change_mm");
        double vertical = deep.get().domeDescentMm();
        return PaperTexts.claim(
                "dimensions",
                Verdict.agrees(ap > 0 && across > 0 && vertical > 0),
                number(ap) + ", " + number(across) + " and " + number(vertical) + " mm");
    }
}
