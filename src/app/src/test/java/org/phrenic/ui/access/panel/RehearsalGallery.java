package org.phrenic.ui.access.panel;

import java.awt.Component;
import java.awt.Container;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.function.BooleanSupplier;
import javax.swing.JTabbedPane;
import javax.swing.SwingUtilities;
import org.phrenic.access.plan.Aids;
import org.phrenic.access.plan.RehearsalPlan;
import org.phrenic.access.ultrasound.ProbePose;
import org.phrenic.access.ultrasound.ScannedSkin;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.observe.Frame;
import org.phrenic.simulation.observe.Surface;
import org.phrenic.ui.access.RehearsalController;
import org.phrenic.ui.access.RehearsalStage;
import org.phrenic.ui.session.EventThread;
import org.phrenic.ui.session.Session;
import org.phrenic.ui.session.WindowPreferences;
import org.phrenic.ui.session.Workspace;
import org.phrenic.ui.window.PhrenicWindow;
import org.phrenic.ui.window.WindowHarness;

/**
 * Leaves pictures of liver access being rehearsed, light and dark, large and small. {@code light-small-in} is
 * {@code rehearse-light.png} of the documentation. Needs a display. Arguments: folder, then those of {@code light-large
 * light-small dark-large dark-small} that are wanted.
 */
public final class RehearsalGallery {
    private static final String RESOLUTION = "resolution=" + System.getProperty("gallery.resolution", "medium");

    private RehearsalGallery() {}

    public static void main(String[] arguments) throws Exception {
        int code = 1;
        try {
            Path folder = Files.createDirectories(Path.of(arguments[0]));
            for (int i = 1; i < arguments.length; i++) {
                boolean large = arguments[i].endsWith("large");
                show(folder, arguments[i], large ? 1600 : 1280, large ? 1000 : 800, arguments[i].startsWith("dark"));
            }
            code = 0;
        } catch (Exception | AssertionError e) {
            e.printStackTrace();
        } finally {
            System.exit(code);
        }
    }

    private static void show(Path folder, String name, int width, int height, boolean dark) throws Exception {
        java.util.prefs.Preferences node =
                java.util.prefs.Preferences.userRoot().node("org/phrenic/rehearsal-gallery");
        node.clear();
        node.putInt("width", width);
        node.putInt("height", height);
        node.putInt("x", 0);
        node.putInt("y", 0);
        node.putBoolean("dark", dark);
        Session session = new Session(Scenario.defaults().with(RESOLUTION));
        PhrenicWindow window = EventThread.get(() -> {
            PhrenicWindow made = new PhrenicWindow(new WindowPreferences(node), session);
            made.show();
            made.showWorkspace(Workspace.CLINICIAN);
            return made;
        });
        RehearsalController rehearsal = window.docks().rehearsalController();
        until(() ->
                rehearsal.stage() == RehearsalStage.READY && rehearsal.state().isPresent());
        EventThread.run(() -> rehearsal.open(RehearsalPlan.exercises().get(0).with(List.of(RESOLUTION))));
        until(() -> rehearsal.stage() != RehearsalStage.READY);
        until(() ->
                rehearsal.stage() == RehearsalStage.READY && rehearsal.state().isPresent());
        EventThread.run(() -> rehearsal.entrySelection().selectBest(false));
        until(() -> rehearsal.entrySelection().advice().isPresent()
                && rehearsal.state().get().hasNeedle());
        Thread.sleep(1500);
        WindowHarness.writeAtRest(window, folder.resolve(name + "-entry.png"));
        EventThread.run(rehearsal.needle()::aimAtTarget);
        until(() -> RehearsalHarness.pointsAtTarget(rehearsal.state().get()));
        EventThread.run(() -> holdProbe(session, rehearsal));
        until(() -> rehearsal.state().get().probe().isPresent());
        Thread.sleep(2500);
        WindowHarness.writeAtRest(window, folder.resolve(name + "-probe.png"));
        // In the pause the liver hardly pulls at the needle.
        until(() -> session.live().status().phaseLabel().equals("expiration"));
        until(() -> session.live().status().phaseLabel().equals("pause"));
        EventThread.run(() -> rehearsal.needle().moveTo(58));
        until(() -> rehearsal.state().get().depthMm() > 57);
        WindowHarness.writeAtRest(window, folder.resolve(name + "-in.png"));
        EventThread.run(() -> rehearsal.setAids(Aids.PICTURES));
        Thread.sleep(2500);
        WindowHarness.writeAtRest(window, folder.resolve(name + "-pictures.png"));
        EventThread.run(() -> {
            rehearsal.setAids(Aids.SECTIONS);
            rehearsal.pictures().setXrayOn(true);
            tab(window, "X-ray");
        });
        Thread.sleep(3000);
        WindowHarness.writeAtRest(window, folder.resolve(name + "-xray.png"));
        EventThread.run(() -> {
            rehearsal.setAids(Aids.SEE_THROUGH);
            rehearsal.pictures().setXrayOn(false);
            tab(window, "Ultrasound");
        });
        EventThread.run(rehearsal.needle()::moveToTarget);
        Thread.sleep(1000);
        EventThread.run(rehearsal.needle()::takeSample);
        until(() -> rehearsal.state().get().samples() > 0);
        EventThread.run(() -> rehearsal.needle().moveTo(0));
        until(() -> !window.docks().attempts().attempts().isEmpty());
        Thread.sleep(1500);
        WindowHarness.writeAtRest(window, folder.resolve(name + "-report.png"));
        EventThread.run(window::close);
        node.removeNode();
    }

    private static void tab(PhrenicWindow window, String title) {
        JTabbedPane tabs = (JTabbedPane) SwingUtilities.getAncestorOfClass(
                JTabbedPane.class, named(window.frame().getRootPane(), "ultrasound"));
        tabs.setSelectedIndex(tabs.indexOfTab(title));
    }

    private static Component named(Container in, String name) {
        for (Component child : in.getComponents()) {
            Component found = name.equals(child.getName())
                    ? child
                    : child instanceof Container deeper ? named(deeper, name) : null;
            if (found != null) {
                return found;
            }
        }
        return null;
    }

    /**
     * Puts the probe 40 mm beside the entry, along the intercostal space, and turns it so that entry and target lie in
     * its plane.
     */
    private static void holdProbe(Session session, RehearsalController rehearsal) {
        List<Surface> surfaces = session.scene().orElseThrow().surfaces();
        Frame rest = session.scene().orElseThrow().newFrame().get();
        double[] entry = rehearsal.entrySelection().entry().orElseThrow();
        double[] target = rehearsal.study().orElseThrow().target().restMm();
        ScannedSkin skin = new ScannedSkin(surfaces);
        double[] place = skin.nearestPoint(new double[] {entry[0], entry[1] - 35, entry[2] - 20});
        double best = Double.POSITIVE_INFINITY;
        ProbePose.Angles chosen = ProbePose.Angles.ZERO;
        for (double rotation = -180; rotation < 180; rotation += 3) {
            for (double tilt = -40; tilt <= 40; tilt += 2) {
                ProbePose.Angles angles = new ProbePose.Angles(rotation, tilt, 0);
                ProbePose pose = skin.at(place).pose(rest, angles);
                double[] t = pose.toProbe(target);
                double off = Math.abs(pose.toProbe(entry)[2]) + Math.abs(t[2]) + 0.1 * Math.abs(t[0]);
                if (off < best) {
                    best = off;
                    chosen = angles;
                }
            }
        }
        rehearsal.probe().put(place);
        rehearsal.probe().turn(chosen.rotationDeg(), chosen.tiltDeg(), chosen.rockDeg());
    }

    private static void until(BooleanSupplier holds) {
        EventThread.until("the stage", holds);
    }
}
