package org.phrenic.ui.window;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.assertj.core.api.Assumptions.assumeThat;

import java.awt.Component;
import java.awt.Container;
import java.awt.Window;
import java.awt.datatransfer.Transferable;
import java.awt.event.MouseEvent;
import java.awt.image.BufferedImage;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javax.swing.AbstractButton;
import javax.swing.JButton;
import javax.swing.JCheckBox;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JDialog;
import javax.swing.JFrame;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JMenu;
import javax.swing.JSlider;
import javax.swing.JTextField;
import javax.swing.JToggleButton;
import javax.swing.KeyStroke;
import javax.swing.TransferHandler;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.MethodOrderer;
import org.junit.jupiter.api.Order;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestMethodOrder;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.phrenic.patient.ScanSamples;
import org.phrenic.scenario.Assignment;
import org.phrenic.scenario.Scenario;
import org.phrenic.scene.camera.Camera;
import org.phrenic.scene.gl.OffscreenContext;
import org.phrenic.simulation.observe.Frame;
import org.phrenic.ui.session.EditName;
import org.phrenic.ui.view.SceneViewport;
import org.phrenic.ui.widget.Theme;

/**
 * The window on the virtual body at low resolution with the paper's material, whose steps are long: what its controls
 * do is looked for in the observables of the run.
 */
@Timeout(120)
@TestMethodOrder(MethodOrderer.OrderAnnotation.class)
class WindowTest {
    /** By this time the first quiet breath is in, s. */
    private static final double IN_S = 2.2;

    /** Any preset has breathed in once more within this time, s. */
    private static final double NEXT_BREATH_S = 8.4;

    /** Longest that an event may keep the window, ms of processor time. */
    private static final double LONGEST_EVENT_MS = 50;

    /** Phase and turn of what stands still, but for rounding of the clock. */
    private static final double STILL = 1e-9;

    private static WindowHarness window;

    @TempDir
    Path folder;

    @BeforeAll
    static void open() throws Exception {
        WindowHarness.assumeDisplay();
        window = new WindowHarness("window", start());
    }

    private static Scenario start() {
        return onMeshOfLow().with("mesh_vertices=3000");
    }

    /** The same with as many vertices as its resolution states. */
    private static Scenario onMeshOfLow() {
        return Scenario.read(Path.of("data", "scenarios", "paper-quiet.yaml")).with("resolution=low", "threads=1");
    }

    @AfterAll
    static void close() throws Exception {
        if (window != null) {
            window.close();
        }
    }

    /** No test computes beside the next one. */
    @AfterEach
    void rest() {
        window.session().live().pause();
    }

    /** Whatever is switched off or put away with the focus: the keys of the window go on to act. */
    @Test
    void theViewHasTheKeysThatNothingElseHasAndTheSpeedDoesNotTakeArrows() {
        WindowHarness.doOnEdt(() -> {
            JFrame frame = window.window().frame();
            assertThat(frame.getFocusTraversalPolicy().getInitialComponent(frame))
                    .isSameAs(window.window().view());
        });
        JComboBox<?> speed = window.control(JComboBox.class, "Speed");
        Object before = WindowHarness.onEdt(speed::getSelectedItem);
        WindowHarness.press(speed, KeyStroke.getKeyStroke("DOWN"));
        assertThat(WindowHarness.onEdt(speed::getSelectedItem)).isEqualTo(before);
        WindowHarness.doOnEdt(() -> speed.setPopupVisible(false));
    }

    /** The first scene from its beginning, flat out; it is loaded anew only where another one runs. */
    private static void asAtFirst() throws Exception {
        begin(start());
    }

    private static void begin(Scenario first) throws Exception {
        long before = id();
        boolean same = WindowHarness.onEdt(() -> {
            Map<String, Object> has =
                    new LinkedHashMap<>(window.session().scenario().toMap());
            Map<String, Object> wanted = first.toMap();
            List<Assignment> back = wanted.keySet().stream()
                    .filter(key -> !wanted.get(key).equals(has.get(key)))
                    .map(key -> Assignment.read("test", key, String.valueOf(wanted.get(key))))
                    .toList();
            boolean live = has.keySet().equals(wanted.keySet())
                    && back.stream().allMatch(a -> a.setting().isLive());
            if (!live) {
                window.session().open(EditName.of("Start"), first);
            } else if (!back.isEmpty()) {
                window.session().change("Start", back.toArray(Assignment[]::new));
            }
            return live;
        });
        if (same) {
            window.session().live().pause();
            window.session().live().reset();
            WindowHarness.await(
                    "the beginning", () -> window.session().live().status().step() == 0);
        } else {
            reloaded("low", before);
        }
        WindowHarness.doOnEdt(() -> {
            window.session().live().setSpeed(Double.POSITIVE_INFINITY);
            window.session().live().play();
        });
        window.breathe(0.05);
    }

    /** Waits until a scene of this resolution runs from its beginning. */
    private static void reloaded(String resolution, long before) throws InterruptedException {
        WindowHarness.await(
                "a scene of resolution " + resolution,
                () -> id() != before && resolution.equals(running().toMap().get("resolution")));
    }

    private static long id() {
        return WindowHarness.onEdt(() -> window.session().scene().orElseThrow().id());
    }

    private static Scenario running() {
        return WindowHarness.onEdt(() -> window.session().scene().orElseThrow().scenario());
    }

    /** Before another test has begun or ended a run. */
    @Order(1)
    @Test
    void theThoraxBreathesAtOnce() throws Exception {
        double step = WindowHarness.onEdt(() -> (double) window.window().view().shownStep());
        window.breathe(0.3);
        if (!window.window().view().isUnavailable()) {
            WindowHarness.await("a newer picture", () -> window.window().view().shownStep() > step);
            BufferedImage picture = WindowHarness.onEdt(
                    () -> window.window().view().frame().orElseThrow().image());
            assertThat(reds(picture))
                    .as("share of the view that is red, as muscle is")
                    .isGreaterThan(0.005);
            window.screenshot("first-minute");
        }
        assertThat(window.control(JComponent.class, "Welcome").isVisible()).isTrue();
    }

    private static double reds(BufferedImage picture) {
        int all = picture.getWidth() * picture.getHeight();
        long red = IntStream.range(0, all)
                .map(i -> picture.getRGB(i % picture.getWidth(), i / picture.getWidth()))
                .filter(rgb -> (rgb >> 16 & 0xff) > 1.5 * (rgb >> 8 & 0xff) && (rgb >> 16 & 0xff) > 80)
                .count();
        return (double) red / all;
    }

    private static void slide(String name, double share) {
        JSlider slider = window.control(JSlider.class, name);
        WindowHarness.doOnEdt(() -> slider.setValue((int) Math.round(share * slider.getMaximum())));
    }

    @Test
    void slidersChangeWhatIsSetAndUndoTakesItBack() throws Exception {
        asAtFirst();
        for (String[] row : new String[][] {
            {"Damping", "damping_ns_per_m"},
            {"Spring stiffness", "spring_stiffness_n_per_m"},
            {"Muscle force", "muscle_force_mn"},
            {"Rib rotation", "rib_rotation"}
        }) {
            Object before = window.set(row[1]);
            slide(row[0], 0.55);
            WindowHarness.await(row[0], () -> !window.set(row[1]).equals(before));
            // Changes of one slider are one change until it rests.
            WindowHarness.doOnEdt(() -> window.session().edits().endMerging());
            window.command("Undo");
            assertThat(window.set(row[1])).as(row[0] + " after undo").isEqualTo(before);
        }
    }

    @Test
    void moreMuscleForcePullsTheDomesDeeper() throws Exception {
        asAtFirst();
        window.breathe(IN_S);
        double usual = window.lowest("dome_right_mm", 0);
        slide("Muscle force", 1);
        assertComesBelow(usual - 2);
    }

    /** Says that within the next breath the right dome comes below a height, mm; waits no longer than that takes. */
    private static void assertComesBelow(double height) throws Exception {
        double from = window.nowS();
        WindowHarness.await(
                "the next breath",
                () -> window.lowest("dome_right_mm", from) < height || window.nowS() > from + NEXT_BREATH_S);
        assertThat(window.lowest("dome_right_mm", from)).isLessThan(height);
    }

    @Test
    void deepIsDeeperThanQuiet() throws Exception {
        asAtFirst();
        window.breathe(IN_S);
        double quiet = window.lowest("dome_right_mm", 0);
        window.command("Deep");
        assertComesBelow(quiet - 2);
        window.screenshot("deep");
    }

    @Test
    void aHeldBreathStaysWhereItIs() throws Exception {
        asAtFirst();
        window.breathe(1);
        window.command("Hold");
        window.breathe(2);
        double held = window.observed("phase");
        double turned = window.observed("rib_turn");
        window.breathe(1);
        assertThat(window.observed("phase")).isCloseTo(held, within(STILL));
        assertThat(window.observed("rib_turn")).isCloseTo(turned, within(STILL));
        window.command("Hold");
        window.breathe(0.5);
        assertThat(window.observed("phase")).isNotCloseTo(held, within(STILL));
    }

    /** After the test that has loaded the scene from which this one begins. */
    @Order(3)
    @Test
    void anotherResolutionIsAnotherScene() throws Exception {
        begin(onMeshOfLow());
        int nodes =
                WindowHarness.onEdt(() -> window.session().scene().orElseThrow().nodes());
        long before = id();
        JComboBox<?> box = window.control(JComboBox.class, "Resolution");
        WindowHarness.doOnEdt(() -> box.setSelectedIndex(1));
        reloaded("medium", before);
        assertThat(WindowHarness.onEdt(
                        () -> window.session().scene().orElseThrow().nodes()))
                .isGreaterThan(nodes);
    }

    private static Optional<Component> named(Container at, String name) {
        return Stream.of(at.getComponents())
                .flatMap(part -> name.equals(part.getName())
                        ? Stream.of(part)
                        : part instanceof Container inner ? named(inner, name).stream() : Stream.empty())
                .findFirst();
    }

    @Test
    void theProgressOfASceneThatLoadsStaysThroughARefusal() throws Exception {
        asAtFirst();
        long before = id();
        Component progress =
                named(window.window().frame().getRootPane(), "loading").orElseThrow();
        WindowHarness.doOnEdt(() -> window.session().open(EditName.of("Medium"), start().with("resolution=medium")));
        WindowHarness.await("the progress", () -> WindowHarness.onEdt(progress::isVisible));
        boolean stays = WindowHarness.onEdt(() -> {
            window.session().refuse("Something else is refused.");
            return progress.isVisible() || !window.session().live().isLoading();
        });
        assertThat(stays).isTrue();
        reloaded("medium", before);
        WindowHarness.await("its end", () -> WindowHarness.onEdt(() -> !progress.isVisible()));
    }

    private static String title() {
        return WindowHarness.onEdt(() -> window.window().frame().getTitle());
    }

    private static boolean drop(Path file) {
        Transferable files = new DroppedFiles(List.of(file.toFile()));
        return WindowHarness.onEdt(() -> {
            JComponent root = window.window().frame().getRootPane();
            return root.getTransferHandler().importData(new TransferHandler.TransferSupport(root, files));
        });
    }

    @Test
    void theWholeThoraxIsShownInTheProjectionThatWasChosen() {
        SceneViewport view = window.window().view();
        boolean before = WindowHarness.onEdt(() -> view.camera().orthographic());
        window.key("5");
        window.key("0");
        assertThat(WindowHarness.onEdt(() -> view.camera().orthographic())).isNotEqualTo(before);
        window.key("5");
        window.key("0");
        assertThat(WindowHarness.onEdt(() -> view.camera().orthographic())).isEqualTo(before);
    }

    /** With the keyboard alone. */
    @Test
    void theCameraTurnsMovesAndZoomsByKeys() {
        SceneViewport view = window.window().view();
        window.key("1");
        window.key("0");
        Camera first = WindowHarness.onEdt(view::camera);
        for (String[] pair : new String[][] {
            {"alt LEFT", "alt RIGHT"},
            {"alt UP", "alt DOWN"},
            {"alt shift LEFT", "alt shift RIGHT"},
            {"alt shift UP", "alt shift DOWN"},
            {"PLUS", "MINUS"},
            {"EQUALS", "MINUS"},
            {"ADD", "SUBTRACT"}
        }) {
            window.key(pair[0]);
            Camera moved = WindowHarness.onEdt(view::camera);
            assertThat(apart(first, moved, view)).as(pair[0]).isGreaterThan(3);
            window.key(pair[1]);
            assertThat(apart(first, WindowHarness.onEdt(view::camera), view))
                    .as("%s after %s", pair[1], pair[0])
                    .isLessThan(1e-6);
        }
        window.key("alt shift UP");
        double[] up = new double[2];
        double[] before = new double[2];
        first.project(40, 0, 1000, view.getWidth(), view.getHeight(), before);
        WindowHarness.onEdt(view::camera).project(40, 0, 1000, view.getWidth(), view.getHeight(), up);
        assertThat(up[1]).as("height of a point, pixels from the top").isLessThan(before[1]);
        window.key("0");
    }

    /** How far some points move in the picture, pixels. */
    private static double apart(Camera a, Camera b, SceneViewport view) {
        double most = 0;
        for (double[] p : new double[][] {{-100, -80, 900}, {120, 60, 1200}}) {
            double[] inA = new double[2];
            double[] inB = new double[2];
            a.project(p[0], p[1], p[2], view.getWidth(), view.getHeight(), inA);
            b.project(p[0], p[1], p[2], view.getWidth(), view.getHeight(), inB);
            most = Math.max(most, Math.hypot(inA[0] - inB[0], inA[1] - inB[1]));
        }
        return most;
    }

    /** Going through a list by keys loads nothing before one of it is chosen. */
    @Test
    void aListIsGoneThroughByKeysBeforeOneOfItIsChosen() throws Exception {
        asAtFirst();
        JComboBox<?> box = window.control(JComboBox.class, "Resolution");
        WindowHarness.doOnEdt(() -> box.scrollRectToVisible(box.getBounds()));
        for (String key : new String[] {"DOWN", "END", "PAGE_DOWN", "DOWN"}) {
            WindowHarness.press(box, KeyStroke.getKeyStroke(key));
            assertThat(window.set("resolution")).isEqualTo("low");
            assertThat(WindowHarness.onEdt(box::isPopupVisible)).isTrue();
        }
        WindowHarness.press(box, KeyStroke.getKeyStroke("ESCAPE"));
        assertThat(WindowHarness.onEdt(box::isPopupVisible)).isFalse();
        assertThat(WindowHarness.onEdt(box::getSelectedItem)).isEqualTo("low");
        long before = id();
        WindowHarness.press(box, KeyStroke.getKeyStroke("DOWN"));
        WindowHarness.press(box, KeyStroke.getKeyStroke("DOWN"));
        WindowHarness.press(box, KeyStroke.getKeyStroke("ENTER"));
        reloaded("medium", before);
        asAtFirst();
    }

    @Test
    void aDroppedScenarioIsOpened() throws Exception {
        Path file = folder.resolve("dropped.yaml");
        Files.writeString(
                file,
                "preset: deep\nmaterial: paper\nresolution: low\nmesh_vertices: 3000\nlungs: off\nrib_rotation: 0.5\n");
        window.session().live().play();
        assertThat(drop(file)).isTrue();
        WindowHarness.await("the dropped scene", () -> running().name().equals("dropped"));
        assertThat(window.set("rib_rotation")).isEqualTo(0.5);
        window.breathe(0.1);
        WindowHarness.await("the title", () -> "dropped - Phrenic".equals(title()));
        window.command("Quiet");
        WindowHarness.await("the title of what is changed", () -> "dropped* - Phrenic".equals(title()));
    }

    /** A spleen and a liver by the numbers of TotalSegmentator, without a rib: imported, and refused as a body. */
    @Test
    void aDroppedLabelVolumeIsImportedWithTheLabelsThatAreChosen() throws Exception {
        Path scan = folder.resolve("scan.mha");
        ScanSamples.writeMha(scan);
        drop(scan);
        JDialog dialog = dialog("import");
        JButton start = dialog.getRootPane().getDefaultButton();
        assertThat(start.isEnabled()).as("no label has a known name").isFalse();
        Path body = folder.resolve("imported");
        WindowHarness.doOnEdt(() -> {
            WindowHarness.find(dialog, JComboBox.class, "Label numbers as in")
                    .orElseThrow()
                    .setSelectedItem("totalsegmentator");
            WindowHarness.find(dialog, JComboBox.class, "Complete from")
                    .orElseThrow()
                    .setSelectedItem("nothing: keep what the scan has");
            WindowHarness.find(dialog, JTextField.class, "Thorax folder")
                    .orElseThrow()
                    .setText(body.toString());
            start.doClick();
        });
        JDialog summary = dialog("import.summary");
        assertThat(Files.readString(body.resolve("labels.csv"))).isEqualTo("label,structure\n1,spleen\n5,liver\n");
        assertThat(body.resolve("spleen.vtp")).isNotEmptyFile();
        assertThat(body.resolve("liver.vtp")).isNotEmptyFile();
        WindowHarness.await(
                "the refusal",
                () -> WindowHarness.onEdt(
                        () -> window.window().banner().message().contains("cannot breathe")));
        WindowHarness.doOnEdt(summary::dispose);
    }

    /** Waits for a dialog of this name. */
    private static JDialog dialog(String name) throws InterruptedException {
        WindowHarness.await(
                "the dialog " + name, () -> WindowHarness.dialog(name).isPresent());
        return WindowHarness.dialog(name).orElseThrow();
    }

    /** A picture that fails, as one of a scene that is being replaced may, leaves the view as it is. */
    @Test
    void aTaskThatFailsDoesNotEndTheView() throws Exception {
        CountDownLatch later = new CountDownLatch(1);
        Consumer<OffscreenContext> failing = gl -> {
            throw new IllegalStateException("found 4754 values, expected 6966");
        };
        window.window().view().runTask(failing, () -> {});
        window.window().view().runTask(gl -> later.countDown(), () -> {});
        assertThat(later.await(30, TimeUnit.SECONDS)).isTrue();
        assertThat(window.window().view().isUnavailable()).isFalse();
    }

    @Test
    void aFileOfAnotherKindIsRefusedInOneSentenceAndChangesNothing() throws Exception {
        Path file = folder.resolve("wrong.yaml");
        Files.writeString(file, "presett: deep\n");
        Object before = WindowHarness.onEdt(() -> window.session().scenario().toMap());
        drop(file);
        WindowHarness.await(
                "the sentence",
                () -> WindowHarness.onEdt(
                        () -> window.window().banner().message().contains("presett")));
        assertThat(WindowHarness.onEdt(() -> window.session().scenario().toMap()))
                .isEqualTo(before);
        window.screenshot("refused");
    }

    @Order(2)
    @Test
    void theWindowStaysResponsiveWhileItRunsFlatOutAndLoads() throws Exception {
        asAtFirst();
        window.breathe(0.5);
        window.forgetDispatches();
        WindowHarness.doOnEdt(() -> window.session().open(EditName.of("Again"), onMeshOfLow()));
        window.breathe(1);
        slide("Damping", 0.4);
        window.breathe(1);
        List<Double> took = window.dispatches();
        // One in a hundred may be the first of its kind, before Java has made it fast.
        assertThat(took.get(took.size() * 99 / 100 - 1)).isLessThan(LONGEST_EVENT_MS);
    }

    /**
     * Light nodes on soft springs without damping, thrown by a breath of jumps, stay within bounds while the muscle is
     * weak.
     */
    private Scenario brittle() throws Exception {
        Path trace = folder.resolve("jumps.csv");
        Files.writeString(
                trace,
                "time_s,amplitude\n0,0\n0.5,0\n0.5001,1\n0.9,1\n0.9001,0\n1,0\n1.5,0\n1.5001,1\n1.9,1\n1.9001,0\n");
        return start().with(
                        "trace=" + trace,
                        "depth=2",
                        "node_mass_kg=0.001",
                        "spring_stiffness_n_per_m=1",
                        "damping_ns_per_m=0",
                        "muscle_force_mn=1");
    }

    @Test
    void aDivergenceIsNamedAndTakenBackAndNeverSeen() throws Exception {
        window.session().live().play();
        long before = id();
        Scenario brittle = brittle();
        WindowHarness.doOnEdt(() -> window.session().open(EditName.of("Brittle"), brittle));
        reloaded("low", before);
        WindowHarness.doOnEdt(() -> window.session().live().setSpeed(Double.POSITIVE_INFINITY));
        slide("Muscle force", 1);
        WindowHarness.await(
                "the banner",
                () -> WindowHarness.onEdt(
                        () -> window.window().banner().message().contains("diverged")));
        assertThat(WindowHarness.onEdt(() -> window.window().banner().message()))
                .contains("restored")
                .contains("the last change was muscle_force_mn");
        assertThat(window.session().live().isPlaying()).isFalse();
        Frame shown = WindowHarness.onEdt(
                () -> window.session().scene().orElseThrow().newFrame().get());
        window.session().live().copyNewestFrame(shown);
        assertThat(shown.isFinite()).as("what the view draws is a number").isTrue();
        window.screenshot("diverged");
        WindowHarness.doOnEdt(() -> window.session().showHistoryFrame(0));
        JButton back = window.control(JButton.class, "Back to the last good state");
        WindowHarness.doOnEdt(back::doClick);
        assertThat(WindowHarness.onEdt(() -> window.session().historyFrame()))
                .as("a recorded frame that hides what goes on")
                .isEmpty();
        WindowHarness.await(
                "the force before", () -> window.set("muscle_force_mn").equals(1.0));
        assertThat(WindowHarness.onEdt(() -> window.window().banner().isVisible()))
                .isFalse();
        window.breathe(0.5);
        assertThat(window.session().live().isPlaying()).isTrue();
    }

    @Test
    void beyondTheStabilityLimitTheWindowSaysSoAndGoesOn() throws Exception {
        asAtFirst();
        JLabel dt = window.control(JLabel.class, "Time step, and the substeps it is split into");
        JTextField field = window.control(JTextField.class, "Time step");
        WindowHarness.doOnEdt(() -> {
            field.setText("0.09");
            field.postActionEvent();
        });
        slide("Spring stiffness", 1);
        WindowHarness.await(
                "split steps", () -> WindowHarness.onEdt(() -> dt.getText().contains(" / ")));
        String why = WindowHarness.onEdt(dt::getToolTipText);
        assertThat(why).contains("beyond the stability limit");
        window.breathe(0.5);
    }

    @Test
    void aClickNamesTheStructureAndItsPlace() throws Exception {
        assumeThat(window.window().view().isUnavailable()).isFalse();
        asAtFirst();
        SceneViewport view = window.window().view();
        WindowHarness.doOnEdt(() -> view.pick(view.getWidth() / 2, view.getHeight() / 2, false));
        JLabel pointed = window.control(JLabel.class, "Structure and place clicked last");
        WindowHarness.await(
                "a name", () -> !WindowHarness.onEdt(pointed::getText).isBlank());
        assertThat(WindowHarness.onEdt(pointed::getText)).matches("[A-Z][a-z].* [LR] \\d+ [AP] \\d+ [SI] \\d+ mm");
        // The way of that point is plotted at a key.
        window.command("Plot this point");
        window.control(JCheckBox.class, "Point 1");
        // In another scene that place may be of another structure.
        long before = id();
        WindowHarness.doOnEdt(() -> window.session()
                .open(EditName.of("Another scene"), running().with("rib_rotation=0.5", "resolution=medium")));
        reloaded("medium", before);
        assertThat(WindowHarness.onEdt(pointed::getText)).isBlank();
        assertThat(WindowHarness.find(window.window().frame().getRootPane(), JCheckBox.class, "Point 1"))
                .isEmpty();
    }

    @Test
    void lookingBackShowsTheRecordedFrame() throws Exception {
        assumeThat(window.window().view().isUnavailable()).isFalse();
        asAtFirst();
        window.breathe(1);
        WindowHarness.await("frames", () -> window.session().live().history().frames() > 3);
        WindowHarness.doOnEdt(() -> window.session().showHistoryFrame(0));
        Frame first = WindowHarness.onEdt(
                () -> window.session().scene().orElseThrow().newFrame().get());
        window.session().live().history().frame(0, first);
        WindowHarness.await(
                "the frame in the view",
                () -> WindowHarness.onEdt(() -> window.window().view().shownStep()) == first.step());
        assertThat(window.session().live().isPlaying()).isFalse();
        JLabel time = window.control(JLabel.class, "Simulated time");
        assertThat(WindowHarness.onEdt(time::getText))
                .as("the foot, as the view")
                .isEqualTo(String.format(Locale.ROOT, "t %.2f s", first.timeS()));
        WindowHarness.doOnEdt(() -> window.session().returnToLive());
        WindowHarness.await(
                "the present",
                () -> WindowHarness.onEdt(() -> window.window().view().shownStep()) > first.step() + 1);
        assertThat(window.session().live().isPlaying()).isTrue();
    }

    private static String said() {
        return WindowHarness.onEdt(() -> window.window().banner().message());
    }

    /** Lets a breath diverge by what no body bears: the lightest sheet under the greatest pressure, undamped. */
    private static void diverge() throws Exception {
        long step = window.session().live().status().step();
        WindowHarness.await("some steps", () -> window.session().live().status().step() > step + 100);
        WindowHarness.doOnEdt(() -> window.session()
                .change(
                        "Too much",
                        Assignment.parse("area_density_kg_per_m2=3"),
                        Assignment.parse("greatest_pressure_kpa=20"),
                        Assignment.parse("damping_rate_per_s=0"),
                        Assignment.parse("muscle_stiffness_n_per_m=30")));
        WindowHarness.await("the sentence", () -> said().contains("diverged"));
    }

    @Test
    void aDivergenceIsSaidUntilTheRunGoesOnAndItsButtonUndoesItsCauseAlone() throws Exception {
        long before = id();
        WindowHarness.doOnEdt(() -> {
            Scenario cough = Scenario.defaults()
                    .with(
                            "resolution=low",
                            "mesh_vertices=3000",
                            "lungs=embedded",
                            "sternum=kinematic",
                            "threads=1",
                            "preset=cough");
            window.session().open(EditName.of("Cough"), cough);
            window.session().live().setSpeed(Double.POSITIVE_INFINITY);
            window.session().live().play();
        });
        WindowHarness.await("the scene", () -> id() != before);
        diverge();
        WindowHarness.doOnEdt(() -> window.session().edits().undo());
        window.command("Play or pause");
        WindowHarness.await("nothing said of a run that goes on", () -> !said().contains("diverged"));
        diverge();
        window.command("Back to the start");
        WindowHarness.await("nothing said", () -> !said().contains("diverged"));
        WindowHarness.doOnEdt(() -> {
            window.session().change("Back", Assignment.parse("damping_rate_per_s=5"));
            window.session().edits().undo();
            window.session().edits().undo();
            window.session().live().play();
        });
        diverge();
        WindowHarness.doOnEdt(() -> window.session().note("Saved a.png."));
        assertThat(said()).contains("diverged");
        window.screenshot("diverged");
        WindowHarness.doOnEdt(() -> {
            Stream.of(window.window().banner().getComponents())
                    .filter(part -> "banner.help".equals(part.getName()))
                    .forEach(part -> ((JButton) part).doClick());
            assertThat(said()).as("what has waited").isNotEmpty().doesNotContain("diverged");
        });
        WindowHarness.await("the run", () -> window.session().live().isPlaying());
        WindowHarness.await("the values", () -> !Double.valueOf(20).equals(window.set("greatest_pressure_kpa")));
        WindowHarness.await(
                "no change to undo again",
                () -> WindowHarness.onEdt(() -> window.session()
                        .edits()
                        .undoPresentationName()
                        .filter("Undo Cough"::equals)
                        .isPresent()));
    }

    @Test
    void lightAndDarkChangeWithoutKeepingTheWindowAndReachWhatIsPutAway() throws Exception {
        window.session().live().play();
        boolean dark = WindowHarness.onEdt(Theme::isDark);
        // Once each way, for Java to know what there is to do.
        for (int i = 0; i < 2; i++) {
            boolean wanted = i == 0 ? !dark : dark;
            window.command("Light or dark");
            WindowHarness.await("the look", () -> WindowHarness.onEdt(() -> isAllOf(wanted)));
        }
        window.forgetDispatches();
        window.command("Light or dark");
        WindowHarness.await("the look", () -> WindowHarness.onEdt(() -> isAllOf(!dark)));
        List<Double> took = window.dispatches();
        // The longest may be the first of its kind, before Java has made it fast.
        assertThat(took.get(took.size() - 2)).isLessThan(LONGEST_EVENT_MS);
        window.command("Light or dark");
        WindowHarness.await("the look", () -> WindowHarness.onEdt(() -> isAllOf(dark)));
    }

    private static boolean isAllOf(boolean dark) {
        java.awt.Color background = javax.swing.UIManager.getColor("Panel.background");
        return Theme.isDark() == dark
                && window.window().docks().components().stream()
                        .filter(part -> part instanceof javax.swing.JPanel)
                        .allMatch(part -> part.getBackground().getRGB() == background.getRGB());
    }

    @Test
    void theBoxOfViewsShowsTheViewThatTheCameraHas() {
        JComboBox<?> box = window.control(JComboBox.class, "View");
        String[][] keys = {
            {"shift 1", "From behind"},
            {"3", "From the left"},
            {"shift 3", "From the right"},
            {"7", "From above"},
            {"shift 7", "From below"},
            {"1", "From the front"}
        };
        for (String[] key : keys) {
            window.key(key[0]);
            assertThat(WindowHarness.onEdt(box::getSelectedItem)).as(key[0]).isEqualTo(key[1]);
        }
        SceneViewport view = window.window().view();
        double y = view.getHeight() / 2.0;
        window.mouse(view, 100, y, MouseEvent.MOUSE_MOVED, MouseEvent.MOUSE_PRESSED);
        window.mouse(view, 140, y, MouseEvent.MOUSE_DRAGGED, MouseEvent.MOUSE_RELEASED);
        assertThat(WindowHarness.onEdt(() -> view.camera().azimuthDeg())).isNotZero();
        assertThat(WindowHarness.onEdt(box::getSelectedItem)).as("dragged").isNull();
        assertThat(WindowHarness.onEdt(() -> shownIn(box))).isEqualTo("Turned");
        WindowHarness.doOnEdt(() -> box.setSelectedIndex(0));
        assertThat(WindowHarness.onEdt(() -> view.camera().azimuthDeg())).isZero();
    }

    private static <T> String shownIn(JComboBox<T> box) {
        JLabel cell = (JLabel) box.getRenderer()
                .getListCellRendererComponent(new JList<>(), box.getItemAt(box.getSelectedIndex()), -1, false, false);
        return cell.getText();
    }

    @Test
    void everyControlSaysWhatItDoes() {
        for (Component control : window.controls()) {
            if (!(control instanceof JMenu)) {
                String name = control.getAccessibleContext().getAccessibleName();
                String tip = WindowHarness.onEdt(((JComponent) control)::getToolTipText);
                assertThat(tip).as("tooltip of " + name).isNotBlank();
            }
        }
    }

    @Test
    void everythingOnTheKeyboardsTourHasAName() {
        for (Component control : window.controls()) {
            String name = control.getAccessibleContext().getAccessibleName();
            assertThat(name).as("accessible name of " + control).isNotBlank();
        }
    }

    @Test
    void aPressOnTheChosenPresetLeavesItChosen() throws Exception {
        asAtFirst();
        JToggleButton quiet = window.control(JToggleButton.class, "Quiet");
        WindowHarness.await("the preset", () -> WindowHarness.onEdt(quiet::isSelected));
        WindowHarness.doOnEdt(quiet::doClick);
        assertThat(WindowHarness.onEdt(quiet::isSelected)).isTrue();
    }

    @Test
    void commandsThatDoNothingAreOff() throws Exception {
        asAtFirst();
        WindowHarness.doOnEdt(() -> {
            while (window.session().edits().undoPresentationName().isPresent()) {
                window.session().edits().undo();
            }
        });
        assertThat(isEnabled("Undo")).isFalse();
        window.command("Deep");
        assertThat(isEnabled("Undo")).isTrue();
        window.command("Undo");
        assertThat(isEnabled("Redo")).isTrue();
        assertThat(List.of("Insert", "Take sample", "Put probe")).noneMatch(WindowTest::isEnabled);
        assertThat(isEnabled("Plots and timeline")).isTrue();
    }

    private static boolean isEnabled(String name) {
        return WindowHarness.onEdt(() -> window.window().commands().all().stream()
                .filter(command -> command.name().equals(name))
                .findFirst()
                .orElseThrow()
                .isEnabled());
    }

    @Test
    void theTableOfKeysIsShownOnce() {
        window.command("Keys");
        window.command("Keys");
        List<Window> shown = Stream.of(Window.getWindows())
                .filter(w -> w.isVisible() && w instanceof JDialog dialog && "Keys".equals(dialog.getTitle()))
                .toList();
        assertThat(shown).hasSize(1);
        WindowHarness.doOnEdt(shown.get(0)::dispose);
    }

    @Test
    void theLogIsClosedByItsButton() {
        window.command("Log");
        JDialog log = Stream.of(Window.getWindows())
                .filter(w -> w.isVisible() && w instanceof JDialog dialog && "Log".equals(dialog.getTitle()))
                .map(JDialog.class::cast)
                .findFirst()
                .orElseThrow();
        WindowHarness.doOnEdt(() -> WindowHarness.find(log.getRootPane(), JButton.class, "Close")
                .orElseThrow()
                .doClick());
        assertThat(log.isVisible()).isFalse();
    }

    /** Keys with Alt: one that a menu has would never reach a button of a dock. */
    @Test
    void mnemonicsAreTakenOnce() {
        List<Integer> mnemonics = window.controls().stream()
                .filter(AbstractButton.class::isInstance)
                .map(control -> ((AbstractButton) control).getMnemonic())
                .filter(key -> key != 0)
                .toList();
        assertThat(mnemonics).doesNotHaveDuplicates();
    }

    @Test
    void keysAreTakenOnce() {
        List<String> keys = window.window().commands().all().stream()
                .map(MenuAction::acceleratorText)
                .filter(text -> !text.isEmpty())
                .toList();
        assertThat(keys).doesNotHaveDuplicates();
    }
}
