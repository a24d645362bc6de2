package org.phrenic.ui.access.panel;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import javax.swing.JComponent;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.phrenic.access.attempt.AttemptEvent;
import org.phrenic.access.attempt.AttemptRecord;
import org.phrenic.access.attempt.ProbeUse;
import org.phrenic.access.attempt.TargetingError;
import org.phrenic.access.plan.Goals;
import org.phrenic.access.plan.PathAdvice;
import org.phrenic.file.Numbers;
import org.phrenic.ui.widget.Controls;

/** The result of an attempt: hit or missed, the targeting error, goals and measures. */
public final class ReportCard extends JPanel {
    private final AdvicePanel verdict = new AdvicePanel("Verdict");
    private final WrappingLabel goals = WrappingLabel.normal("Goals");
    private final WrappingLabel measures = WrappingLabel.normal("Measures of the attempt");
    private final WrappingLabel notice = WrappingLabel.secondary("Thresholds");

    public ReportCard() {
        super(new MigLayout("insets 0, gap 0 8, fillx, hidemode 3, wrap 1", "[grow, fill]"));
        setName("report card");
        for (JComponent part : new JComponent[] {verdict, goals, measures, notice}) {
            add(part, "wmin 0");
        }
        notice.setTextIfChanged(AttemptRecord.NOT_VALIDATED);
        setVisible(false);
    }

    void show(EndedAttempt attempt) {
        AttemptRecord record = attempt.record();
        boolean asks = !attempt.plan().goals().evaluate(record).isEmpty();
        boolean done = attempt.goalsReached() && (asks || record.hit());
        verdict.setAdvice(
                done ? PathAdvice.Level.FREE : record.hit() ? PathAdvice.Level.CAREFUL : PathAdvice.Level.BARRED,
                headline(attempt, asks),
                sampleText(record));
        goals.setTextIfChanged(String.join("\n", goals(attempt)));
        goals.setVisible(asks);
        List<String> lines = measures(record);
        lines.addAll(0, guidance(attempt));
        measures.setTextIfChanged(String.join("\n", lines));
        setVisible(true);
        revalidate();
        repaint();
    }

    public String text() {
        return verdict.text() + "\n" + goals.getText() + "\n" + measures.getText();
    }

    private static String headline(EndedAttempt attempt, boolean asks) {
        String hit = attempt.record().verdict();
        return asks ? hit + (attempt.goalsReached() ? ", and done" : ", not done") : hit;
    }

    static String sampleText(AttemptRecord record) {
        return record.decisive()
                .map(sample -> sampleText(record, sample))
                .orElse("The needle was removed without a sample.");
    }

    private static String sampleText(AttemptRecord record, TargetingError sample) {
        String core = sample.coreInTargetMm().isEmpty()
                ? ""
                : Numbers.format(
                        " Of the core of %s mm, %.1f mm lay in it.",
                        number(sample.coreMm()), sample.coreInTargetMm().getAsDouble());
        String what = core.isEmpty() ? "the tip" : "the middle of the core";
        return Controls.capitalise(record.whichSample() + what) + place(sample) + core;
    }

    static String place(TargetingError sample) {
        return Numbers.format(
                " was %.1f mm from the middle of the target: %.1f mm %s, %.1f mm aside.",
                sample.distanceMm(),
                Math.abs(sample.axialMm()),
                sample.axialMm() < 0 ? "too deep" : "short of it",
                sample.lateralMm());
    }

    private static List<String> goals(EndedAttempt attempt) {
        List<String> lines = new ArrayList<>();
        for (Goals.GoalResult o : attempt.plan().goals().evaluate(attempt.record())) {
            String measure =
                    o.measure() + ": " + o.reachedText(ReportCard::number) + " (at most " + number(o.limit()) + ")";
            lines.add((o.reached() ? "\u2713 " : "\u2717 ") + (o.goal().equals("hit") ? "target hit" : measure));
        }
        return lines;
    }

    private static List<String> measures(AttemptRecord r) {
        List<String> lines = new ArrayList<>();
        lines.add("Time " + number(r.timeS()) + " s, in the body " + number(r.insideS()) + " s");
        lines.add("Skin punctures " + r.count(AttemptEvent.Kind.SKIN_PUNCTURE) + ", redirections "
                + r.count(AttemptEvent.Kind.REDIRECTION) + ", contacts with bone "
                + r.count(AttemptEvent.Kind.BONE_CONTACT));
        lines.add("In no-go structures " + number(r.inNoGoS()) + " s");
        r.secondsIn().forEach((what, s) -> {
            if (s > 0) {
                lines.add("   in " + what.label() + " " + number(s) + " s"
                        + (r.avoided().contains(what) ? "" : " (allowed here)"));
            }
        });
        if (!r.zones().byCore().isEmpty()) {
            lines.add("Touched by a core: " + r.zones().coreText());
        }
        lines.add("Path of the tip " + number(r.tipTravelMm()) + " mm; the target moved "
                + number(r.targetExcursionMm()) + " mm");
        lines.add("Capsule pulled aside " + number(r.capsulePullMm()) + " mm"
                + (r.capsulePullMm() > AttemptRecord.PULL_WARNING_MM ? " (warning)" : ""));
        lines.add("Greatest force, N: " + r.loads().peaks());
        lines.add("Capsule pushed " + number(r.loads().capsulePushMm()) + " mm; needle bent "
                + number(r.loads().bendingMm()) + " mm by " + number(r.loads().sideN()) + " N from the side");
        addEvent(r, AttemptEvent.Kind.SKIN_PUNCTURE, "Skin", lines);
        addEvent(r, AttemptEvent.Kind.CAPSULE_PUNCTURE, "Capsule", lines);
        addEvent(r, AttemptEvent.Kind.SAMPLE, "Sample", lines);
        return lines;
    }

    /** Who aimed, what was shown, and how the probe was used. */
    private static List<String> guidance(EndedAttempt attempt) {
        List<String> lines = new ArrayList<>();
        long aims = attempt.plan().aimsByProgram();
        String aimed = aims == 0 ? "Aimed by hand" : "Aimed by the program " + (aims == 1 ? "once" : aims + " times");
        lines.add(aimed + "; help: " + attempt.plan().aids().label().toLowerCase(Locale.ROOT));
        ProbeUse probe = attempt.probe();
        if (probe.isUsed()) {
            lines.add("Probe " + number(probe.probeS()) + " s; tip in the body and out of the beam "
                    + number(probe.tipUnseenS()) + " s");
            lines.add("Needle in the beam " + number(probe.needleInBeamMm()) + " mm on average, "
                    + Math.round(100 * probe.needleInBeamShare()) + " %");
        }
        return lines;
    }

    private static void addEvent(AttemptRecord r, AttemptEvent.Kind kind, String name, List<String> lines) {
        r.first(kind).ifPresent(e -> {
            String format = "%s at %.1f s, breath %d, %s, %.0f mm deep";
            lines.add(Numbers.format(
                    format, name, e.timeS(), e.breath(), e.phase().label(), e.depthMm()));
        });
    }

    private static String number(double value) {
        return Numbers.format(value == Math.rint(value) ? "%.0f" : "%.1f", value);
    }
}
