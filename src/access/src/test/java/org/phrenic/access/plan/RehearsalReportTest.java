package org.phrenic.access.plan;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.phrenic.access.BodySurfaces;
import org.phrenic.access.BoxAnatomy;
import org.phrenic.access.BreathMoment;
import org.phrenic.access.MovingAnatomy;
import org.phrenic.access.Needle;
import org.phrenic.access.TargetLesion;
import org.phrenic.access.attempt.NeedleInsertion;
import org.phrenic.access.attempt.NeedleSnapshot;
import org.phrenic.access.attempt.TargetingError;
import org.phrenic.access.path.TargetAccess;
import org.phrenic.access.ultrasound.ProbePose;
import org.phrenic.access.ultrasound.UltrasoundSettings;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.breathing.RespiratoryPhase;
import org.phrenic.document.report.HtmlPage;
import org.phrenic.engine.parallel.Workers;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.model.assembly.Breathing;
import org.phrenic.scenario.Assignment;
import org.phrenic.scenario.RunSettings;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.observe.Surface;

class RehearsalReportTest {
    private static final double AT_ONCE = 1e6;
    private static final double[] ENTRY = {0, 0, -20};

    /** The tip 3 mm beyond the middle of the target and 4 mm beside it. */
    @Test
    void theHeadlineTellsWhatIsAlongTheNeedleFromWhatIsAside() {
        TargetingError sample = new TargetingError(-3, 4, true, 0, OptionalDouble.empty());
        assertThat(RehearsalReport.place(sample)).isEqualTo("-3.0 mm along the needle, 4.0 mm aside");
    }

    /** The report of samples at these depths on the way to a target of 20 mm in a depth of 90 mm, to be read. */
    private static String report(double... depthsMm) {
        return report(Scenario.defaults(), Needle.standard(), depthsMm);
    }

    private static String report(Scenario scenario, Needle tube, double... depthsMm) {
        return page(report(new BoxAnatomy(), scenario, tube, false, depthsMm));
    }

    private static String page(RehearsalReport report) {
        return HtmlPage.format(report.document(List.of(), List.of(), "today"));
    }

    /** @param imaged whether the plan takes an ultrasound image */
    private static RehearsalReport report(
            BoxAnatomy body, Scenario scenario, Needle tube, boolean imaged, double... depthsMm) {
        return report(4, body, new BodySurfaces(body.surfaces), scenario, tube, imaged, depthsMm);
    }

    /** @param periodS period of the breathing */
    private static RehearsalReport report(
            double periodS,
            BoxAnatomy body,
            BodySurfaces shown,
            Scenario scenario,
            Needle tube,
            boolean imaged,
            double... depthsMm) {
        MovingAnatomy scene = new MovingAnatomy(body.surfaces);
        scene.update(body.still(0));
        TargetLesion target = TargetLesion.at(scene, new double[] {90, 0, -20}, 20);
        List<BreathMoment> breath = List.of(new BreathMoment(body.still(0), RespiratoryPhase.PAUSE, periodS));
        RehearsalPlan plan = RehearsalPlan.practice(scenario, target, tube, breath.size());
        try (Workers workers = Workers.of(1)) {
            TargetAccess access = TargetAccess.of(scene, breath, target, plan.needle(), plan.avoided(), workers);
            NeedleInsertion needle = new NeedleInsertion(scene, target, plan.needle(), plan.avoided());
            needle.update(body.still(0), RespiratoryPhase.PAUSE);
            needle.place(ENTRY, needle.targetNow());
            for (int i = 0; i < depthsMm.length; i++) {
                needle.advance(depthsMm[i], AT_ONCE);
                needle.update(body.still(1 + i), RespiratoryPhase.PAUSE);
                needle.sample();
            }
            NeedleSnapshot moment = new NeedleSnapshot(
                    "ultrasound_1", body.still(0), RespiratoryPhase.PAUSE, false, ENTRY, ENTRY, target.restMm(), 10);
            ProbeHold hold = ProbeHold.at(ENTRY, ProbePose.Angles.ZERO, UltrasoundSettings.DEFAULT);
            Rehearsal rehearsal = new Rehearsal(
                    imaged ? plan.withSteps(target, List.of(new PlanStep.Image("image", hold)), 1) : plan,
                    shown,
                    access,
                    Optional.empty(),
                    needle.record(),
                    new HeldProbe(scene).use(),
                    imaged ? List.of(moment) : List.of(),
                    "");
            return new RehearsalReport(rehearsal);
        }
    }

    /** As a vessel that a scan cuts off on all sides. */
    @Test
    void imagesNameTheStructuresThatAreTooOpenToBeSeen() {
        RehearsalReport whole = report(new BoxAnatomy(), Scenario.defaults(), Needle.standard(), true);
        assertThat(whole.values().toString()).contains("mm_per_pixel").doesNotContain("left_out");
        assertThat(page(whole)).contains("marker on the left").doesNotContain("Not in the images");
        BoxAnatomy body = new BoxAnatomy();
        TriangleMesh sheet = new TriangleMesh(new double[] {60, 0, 0, 70, 0, 0, 60, 10, 0}, new int[] {0, 1, 2});
        body.surfaces.add(new Surface(
                "vessel_open", StructureKind.VESSEL, 0, Side.MIDLINE, sheet, Surface.Motion.STILL, new boolean[0]));
        RehearsalReport cut = report(body, Scenario.defaults(), Needle.standard(), true);
        assertThat(cut.values().toString()).contains("left_out=[vessel_open]");
        assertThat(page(cut)).contains("Not in the images, as they are open: vessel_open.");
    }

    @Test
    void theReportNamesWhatIsNotOfThisPerson() {
        RehearsalReport seen = report(new BoxAnatomy(), Scenario.defaults(), Needle.standard(), false);
        assertThat(page(seen)).doesNotContain("of this person");
        assertThat(seen.values()).doesNotContainKey("not_in_scan");
        BoxAnatomy body = new BoxAnatomy();
        BodySurfaces unseen = new BodySurfaces(body.surfaces, Set.of("skin", "lung_R"), "lung, skin");
        RehearsalReport report = report(4, body, unseen, Scenario.defaults(), Needle.standard(), false);
        assertThat(page(report)).contains("Not in the scan, and so not of this person: lung, skin.");
        assertThat(report.values()).containsEntry("not_in_scan", List.of("lung_R", "skin"));
    }

    /** Without a needle there is no path that could tell. */
    @Test
    void theAccessMapSaysWhatOfALongRecordingItDoesNotJudge() {
        BoxAnatomy body = new BoxAnatomy();
        BodySurfaces seen = new BodySurfaces(body.surfaces);
        String limits = "judged at 1 moments of the first 40 s";
        RehearsalReport cut = report(60, body, seen, Scenario.defaults(), Needle.standard(), false);
        assertThat(cut.values().get("access").toString()).contains("limits=" + limits);
        assertThat(page(cut)).contains("in part of it; " + limits);
        RehearsalReport whole = report(40, body, seen, Scenario.defaults(), Needle.standard(), false);
        assertThat(whole.values().get("access").toString()).doesNotContain("limits=");
        assertThat(page(whole)).contains("in part of it.");
    }

    @Test
    void theReportNamesThePresetOrTheRecordingThatTheBodyBreathesBy() {
        assertThat(report(Scenario.defaults().with("preset=deep"), Needle.standard()))
                .contains("Breathing: deep. Help: ");
        Assignment recording = Assignment.of("test", Breathing.TRACE, Optional.of(Path.of("some", "patient 7.csv")));
        assertThat(report(Scenario.defaults().with("preset=deep").with(List.of(recording)), Needle.standard()))
                .contains("Breathing: recorded, patient 7.csv. Help: ");
    }

    /** A page is printed and handed on, and folders may have the names of users and patients. */
    @Test
    void theReportNamesTheFolderOfTheBodyAndNoneAboveIt() {
        Path body = Path.of("patients", "MUELLER 1951", "scan-body").toAbsolutePath();
        Scenario ofFolder =
                Scenario.defaults().with(List.of(Assignment.of("test", RunSettings.ANATOMY, body.toString())));
        assertThat(report(ofFolder, Needle.standard()))
                .contains("Body: scan-body. Breathing: ")
                .doesNotContain("MUELLER");
        assertThat(report(Scenario.defaults(), Needle.standard()))
                .contains("Body: " + RunSettings.VIRTUAL_MAN + ". Breathing: ");
    }

    @Test
    void theHeadlineTellsADistanceOfTheSampleThatItsVerdictIsOf() {
        String of = " mm from the middle of a target of 20.0 mm";
        assertThat(report(88)).contains("Hit: the tip was 2.0" + of);
        assertThat(report(60)).contains("Missed: the tip was 30.0" + of);
        assertThat(report(84, 88, 60)).contains("Hit in 2 of 3 samples: in the nearest that hit, the tip was 2.0" + of);
        assertThat(report(70, 60)).contains("Missed in 2 samples: in the last, the tip was 30.0" + of);
        assertThat(report()).contains("No sample was taken.");
    }

    /** The tip of a core needle stops before the target; the core that it throws hits. */
    @Test
    void theDefinitionOfAHitIsThatOfTheNeedle() {
        Needle core = new Needle(18, Needle.standard().lengthMm(), 20);
        String ofTip = "Hit: the tip was in the liver and within the target";
        String ofCore = "Hit: a part of the core was within the target";
        assertThat(report(75)).contains("Missed: ", ofTip).doesNotContain(ofCore);
        assertThat(report(Scenario.defaults(), core, 75)).contains(ofCore).doesNotContain("Missed: ", ofTip);
    }
}
