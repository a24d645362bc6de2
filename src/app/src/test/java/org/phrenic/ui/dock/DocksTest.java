package org.phrenic.ui.dock;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.data.Percentage.withPercentage;

import java.awt.Component;
import java.awt.Container;
import java.awt.Paint;
import java.awt.event.FocusEvent;
import java.awt.event.FocusListener;
import java.awt.event.MouseEvent;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javax.swing.JButton;
import javax.swing.JCheckBox;
import javax.swing.JComboBox;
import javax.swing.JLabel;
import javax.swing.JSlider;
import javax.swing.JTextField;
import javax.swing.JToggleButton;
import javax.swing.SwingUtilities;
import org.jfree.chart.plot.CombinedDomainXYPlot;
import org.jfree.chart.plot.IntervalMarker;
import org.jfree.chart.plot.XYPlot;
import org.jfree.chart.ui.Layer;
import org.jfree.data.xy.XYDataset;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.phrenic.breathing.RespiratoryPhase;
import org.phrenic.breathing.pattern.BreathingPreset;
import org.phrenic.file.BadInputException;
import org.phrenic.file.Numbers;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.io.MeshFiles;
import org.phrenic.model.assembly.Breathing;
import org.phrenic.model.material.Materials;
import org.phrenic.model.material.Muscle;
import org.phrenic.model.material.Numerics;
import org.phrenic.model.material.RibRotation;
import org.phrenic.model.material.SheetSprings;
import org.phrenic.model.material.TransdiaphragmaticPressure;
import org.phrenic.model.material.WallContact;
import org.phrenic.model.organ.OrganSettings;
import org.phrenic.parameter.Parameter;
import org.phrenic.parameter.Setting;
import org.phrenic.scenario.Assignment;
import org.phrenic.scenario.RunSettings;
import org.phrenic.scenario.Scenario;
import org.phrenic.scene.style.ColourField;
import org.phrenic.simulation.live.LiveScene;
import org.phrenic.simulation.live.RunHistory;
import org.phrenic.simulation.live.RunStatus;
import org.phrenic.simulation.observe.Frame;
import org.phrenic.simulation.observe.Observation;
import org.phrenic.simulation.observe.Surface;
import org.phrenic.ui.chart.BreathComparison;
import org.phrenic.ui.chart.PhaseColours;
import org.phrenic.ui.chart.PlotDock;
import org.phrenic.ui.chart.TimelineDock;
import org.phrenic.ui.session.EditName;
import org.phrenic.ui.session.EventThread;
import org.phrenic.ui.session.MessageListener;
import org.phrenic.ui.session.ScenarioStore;
import org.phrenic.ui.session.Session;
import org.phrenic.ui.view.AppearanceModel;
import org.phrenic.ui.widget.SliderScale;
import org.phrenic.ui.widget.Theme;
import org.phrenic.ui.widget.TypedText;
import org.phrenic.ui.window.WindowHarness;

/**
 * The docks over a simulation that really runs: the coarse sheet alone, which breathes as the whole scene does. Needs
 * no display.
 */
class DocksTest {
    private static final Scenario FIRST = WindowHarness.COARSE_SHEET;
    private static final int DOME = Observation.COLUMNS.indexOf("dome_right_mm");

    private static Session session;

    @BeforeAll
    static void begin() {
        session = EventThread.get(() -> new Session(FIRST));
        EventThread.until("the scene is there", () -> session.scene().isPresent());
        session.live().setSpeed(Double.POSITIVE_INFINITY);
    }

    @AfterAll
    static void end() {
        EventThread.run(session::close);
    }

    @BeforeEach
    void asAtFirst() {
        EventThread.run(() -> {
            session.returnToLive();
            session.live().play();
            while (session.edits().undoPresentationName().isPresent()) {
                session.edits().undo();
            }
        });
        EventThread.until(
                "the first settings are back", () -> session.scenario().equals(FIRST));
    }

    private static <T> T on(Callable<T> what) {
        return EventThread.get(what);
    }

    private static SliderRow row(ParameterDock dock, String key) {
        return (SliderRow)
                dock.rows().stream().filter(r -> r.isFor(key)).findFirst().orElseThrow();
    }

    @Test
    void everyParameterHasARowAndNothingElseHas() {
        ParameterDock dock = on(() -> new ParameterDock(session));
        List<String> choices = Stream.<Setting<?>>of(
                        Materials.MATERIAL,
                        RunSettings.ANATOMY,
                        OrganSettings.RESOLUTION,
                        Numerics.TIME_STEP,
                        Numerics.INTEGRATOR,
                        Numerics.THREADS)
                .map(Setting::key)
                .toList();
        List<String> keys = Stream.concat(
                        choices.stream(), Materials.parameters().stream().map(Setting::key))
                .toList();
        assertThat(dock.rows()).hasSameSizeAs(keys);
        assertThat(keys).allSatisfy(key -> assertThat(dock.rows()).anyMatch(row -> row.isFor(key)));
    }

    /**
     * Another material is another scene: it is chosen in a session of its own, so that no other test sees it arrive.
     */
    @Test
    void theMaterialChosenHereIsThatOfTheCommandLineAndBack() {
        Session own = on(() -> new Session(FIRST));
        try {
            ParameterDock dock = on(() -> new ParameterDock(own));
            ChoiceRow material = (ChoiceRow) dock.rows().stream()
                    .filter(r -> r.isFor("material"))
                    .findFirst()
                    .orElseThrow();
            EventThread.run(() -> material.comboBox().setSelectedItem("paper"));
            assertThat(on(() -> own.scenario())).isEqualTo(FIRST.with("material=paper"));
            EventThread.run(() -> dock.onChange());
            // The paper's sheet has one stiffness, the physical tendon ten times that of the muscle.
            assertThat(on(() -> row(dock, "tendon_stiffness_ratio").field().getToolTipText()))
                    .contains("default 1;");
            EventThread.run(() -> material.comboBox().setSelectedItem("physical"));
            EventThread.run(() -> dock.onChange());
            assertThat(on(() -> row(dock, "tendon_stiffness_ratio").field().getToolTipText()))
                    .contains("default 10;");
            assertThat(on(() -> own.scenario())).isEqualTo(FIRST);
            EventThread.run(() -> own.edits().undo());
            EventThread.run(() -> own.edits().undo());
            assertThat(on(() -> own.scenario())).isEqualTo(FIRST);
        } finally {
            EventThread.run(own::close);
        }
    }

    @Test
    void rowsOfTheMaterialAreShownAndASearchNarrowsThem() {
        ParameterDock dock = on(() -> new ParameterDock(session));
        for (Parameter parameter : Materials.parameters()) {
            assertThat(row(dock, parameter.key()).isVisible()).isEqualTo(Materials.PHYSICAL.uses(parameter));
        }
        EventThread.run(() -> dock.search().setText("tendon stiff"));
        assertThat(dock.rows().stream().filter(SettingRow::isVisible))
                .hasSizeBetween(1, 3)
                .contains(row(dock, "tendon_stiffness_ratio"));
        assertThat(dock.nothingFound().isVisible()).isFalse();
        JButton heading =
                (JButton) row(dock, "tendon_stiffness_ratio").getParent().getComponent(0);
        String open = heading.getText();
        EventThread.run(heading::doClick);
        assertThat(heading.getText()).as("while the search shows its rows").isEqualTo(open);
        EventThread.run(() -> dock.search().setText(""));
        assertThat(row(dock, "tendon_stiffness_ratio").isVisible()).isTrue();
        EventThread.run(() -> dock.search().setText("muscle force"));
        assertThat(dock.nothingFound().isVisible()).isTrue();
        assertThat(dock.nothingFound().getText()).contains("'physical'").contains("Other materials have Muscle force");
    }

    @Test
    void aRowNamesItselfForScreenReaders() {
        ParameterDock dock = on(() -> new ParameterDock(session));
        for (Parameter parameter : Materials.parameters()) {
            SliderRow row = row(dock, parameter.key());
            assertThat(row.field().getAccessibleContext().getAccessibleName()).isEqualTo(parameter.label());
            assertThat(row.slider().getAccessibleContext().getAccessibleName()).isEqualTo(parameter.label());
            assertThat(row.field().getToolTipText()).contains(parameter.key());
        }
    }

    @Test
    void whatIsTypedBeyondTheRangeIsSetToItsEndAndSaidSo() {
        ParameterDock dock = on(() -> new ParameterDock(session));
        SliderRow row = row(dock, "muscle_stiffness_n_per_m");
        EventThread.run(() -> {
            row.field().setText("9000");
            row.field().postActionEvent();
        });
        assertThat(on(() -> session.scenario().get(SheetSprings.MUSCLE_STIFFNESS)))
                .isEqualTo(3000);
        assertThat(row.field().getText()).isEqualTo("3000");
        // So stiff a sheet splits steps, which the row has to say too; what was typed comes first.
        EventThread.until("steps are split", () -> session.live().status().substeps() > 1);
        EventThread.run(() -> {
            dock.onTick(session.live().status());
            dock.onChange();
        });
        assertThat(row.message()).isEqualTo("9000 N/m is out of range; the largest, 3000 N/m, is taken.");
        EventThread.run(() -> {
            row.field().setText("stiff");
            row.field().postActionEvent();
        });
        assertThat(row.field().getText()).isEqualTo("3000");
        assertThat(row.message()).isEqualTo("Found 'stiff', expected a number from 30 to 3000 N/m.");
        EventThread.run(() -> row.resetButton().doClick());
        assertThat(on(() -> session.scenario().get(SheetSprings.MUSCLE_STIFFNESS)))
                .isEqualTo(300);
        assertThat(row.resetButton().isEnabled()).isFalse();
        assertThat(row.message()).doesNotContain("stiff'");
    }

    @Test
    void draggingIsOneChangeToUndo() {
        ParameterDock dock = on(() -> new ParameterDock(session));
        SliderRow row = row(dock, "depth");
        EventThread.run(() -> {
            row.slider().setValueIsAdjusting(true);
            for (int part = 4; part <= 8; part++) {
                row.slider().setValue(part * SliderScale.POSITIONS / 8);
            }
            row.slider().setValueIsAdjusting(false);
        });
        assertThat(on(() -> session.scenario().get(Breathing.DEPTH))).isEqualTo(2);
        assertThat(on(() -> session.edits().undoPresentationName())).hasValue("Undo Depth 1 -> 2");
        EventThread.run(() -> session.edits().undo());
        assertThat(on(() -> session.scenario().get(Breathing.DEPTH))).isEqualTo(1);
        EventThread.until("the row shows it", () -> row.field().getText().equals("1"));
    }

    /** Villard, Bourne and Bello 2009 step by 10 ms. */
    @Test
    void theTimeStepIsResetToThatOfTheMaterial() {
        Scenario published = FIRST.withMaterial(Materials.PUBLISHED);
        Session own = on(() -> new Session(published));
        try {
            ParameterDock dock = on(() -> new ParameterDock(own));
            EventThread.run(() -> own.change("A shorter step", Assignment.read("test", "time_step_s", "0.002")));
            EventThread.run(dock::onChange);
            assertThat(on(() -> row(dock, "time_step_s").field().getToolTipText()))
                    .contains("default 0.01 s;");
            EventThread.run(dock::resetAll);
            assertThat(on(() -> own.scenario()).timeStepS()).isEqualTo(0.01);
        } finally {
            EventThread.run(own::close);
        }
    }

    @Test
    void aSmallNumberIsShownWholeAndTheTipOfASliderLeavesItInSight() {
        EventThread.run(() -> {
            ParameterDock dock = new ParameterDock(session);
            SliderRow row = row(dock, "time_step_s");
            row.field().setText("0.001234");
            row.setSize(300, row.getPreferredSize().height);
            row.doLayout();
            assertThat(row.field().getWidth())
                    .isGreaterThanOrEqualTo(row.field().getPreferredSize().width);
            MouseEvent over = new MouseEvent(row.slider(), MouseEvent.MOUSE_MOVED, 0, 0, 20, 5, 0, false);
            assertThat(row.slider().getToolTipLocation(over).y)
                    .isGreaterThanOrEqualTo(row.slider().getHeight());
        });
    }

    @Test
    void resetAllIsOneChange() {
        ParameterDock dock = on(() -> new ParameterDock(session));
        EventThread.run(() -> session.change(
                "Two at once",
                Assignment.read("test", "depth", "1.5"),
                Assignment.read("test", "rib_rotation", "0.5")));
        EventThread.run(dock::resetAll);
        Scenario now = on(() -> session.scenario());
        assertThat(now.get(Breathing.DEPTH)).isEqualTo(1);
        assertThat(now.get(RibRotation.RIB_ROTATION)).isEqualTo(1);
        assertThat(now.get(Breathing.RATE)).isEqualTo(15);
        EventThread.run(() -> session.edits().undo());
        assertThat(on(() -> session.scenario().get(Breathing.DEPTH))).isEqualTo(1.5);
    }

    /** Deepest that the right dome goes in the next breath, of 1.5 s, after half a second, mm. */
    private static double excursion() {
        double from = session.live().status().timeS() + 0.5;
        EventThread.until("a breath has passed", () -> session.live().status().timeS() > from + 1.6);
        RunHistory history = session.live().history();
        double least = 0;
        for (int i = 0; i < history.size(); i++) {
            if (history.time(i) > from) {
                least = Math.min(least, history.values(i)[DOME]);
            }
        }
        return -least;
    }

    @Test
    void undoRestoresHowTheDomeMoves() {
        double before = excursion();
        EventThread.run(() -> session.change("Depth 1 -> 0.3", Assignment.read("test", "depth", "0.3")));
        double shallow = excursion();
        EventThread.run(() -> session.edits().undo());
        double after = excursion();
        assertThat(before).isGreaterThan(5);
        assertThat(shallow).isLessThan(0.6 * before);
        assertThat(after).isCloseTo(before, withPercentage(5));
    }

    /** Such a breath, if it is held in a rehearsal, goes on in place. */
    @Test
    void aBreathIsOfAPresetAsThatIsHeldOrNot() {
        Scenario quiet = Scenario.defaults();
        assertThat(BreathDock.isBreathOf(quiet, "quiet")).isTrue();
        assertThat(BreathDock.isBreathOf(quiet.with("hold=true"), "quiet")).isTrue();
        assertThat(BreathDock.isBreathOf(quiet, "deep")).isFalse();
        assertThat(BreathDock.isBreathOf(quiet.with("rate_per_min=25"), "quiet"))
                .isFalse();
    }

    @Test
    void aPresetButtonBreathesByItAndHoldsStopTheBreath() {
        BreathDock dock = on(() -> new BreathDock(session));
        for (String name : BreathingPreset.names()) {
            assertThat(dock.presetButton(name).getToolTipText()).contains(name);
        }
        EventThread.run(() -> dock.presetButton("deep").doClick());
        Scenario deep = on(() -> session.scenario());
        assertThat(deep.preset()).isEqualTo("deep");
        // The rate that was set by hand gives way to that of the preset.
        assertThat(deep.get(Breathing.RATE))
                .isEqualTo(deep.breathing().parameters().ratePerMin());
        EventThread.run(() -> dock.holdButton().doClick());
        assertThat(on(() -> session.scenario().hold())).isTrue();
        EventThread.run(() -> session.edits().undo());
        EventThread.run(() -> session.edits().undo());
        assertThat(on(() -> session.scenario())).isEqualTo(FIRST);
        EventThread.until("the button is up", () -> !dock.holdButton().isSelected());
    }

    /** The first settings have a rate of their own. */
    @Test
    void theSelectedPresetTakesBackTheRateThatWasSetByHand() {
        BreathDock dock = on(() -> new BreathDock(session));
        EventThread.run(() -> dock.selectPreset(FIRST.preset()));
        Scenario back = on(() -> session.scenario());
        assertThat(back.get(Breathing.RATE))
                .isEqualTo(back.breathing().parameters().ratePerMin());
        String undo = on(() -> session.edits().undoPresentationName().orElseThrow());
        EventThread.run(() -> session.edits().undo());
        EventThread.run(() -> dock.selectPreset(FIRST.preset()));
        EventThread.run(() -> dock.selectPreset(FIRST.preset()));
        EventThread.run(() -> session.edits().undo());
        assertThat(undo).contains("Breathing");
        assertThat(on(() -> session.scenario()))
                .as("one press more changes nothing")
                .isEqualTo(FIRST);
    }

    @Test
    void aFileThatIsNoTraceIsRefusedInOneSentence(@TempDir Path folder) throws Exception {
        Path bad = Files.writeString(folder.resolve("bad.csv"), "hello,world\n1,2\n");
        AtomicReference<String> said = new AtomicReference<>();
        Session.Listener ear = new MessageListener(said::set);
        EventThread.run(() -> {
            session.addListener(ear);
            new BreathDock(session).openTrace(bad);
        });
        EventThread.until("a refusal", () -> said.get() != null);
        EventThread.run(() -> session.removeListener(ear));
        assertThat(said.get()).contains("bad.csv").contains("time_s,amplitude");
        assertThat(on(() -> session.scenario().trace())).isEmpty();
    }

    @Test
    void aForceIsSwitchedOffAndOn() {
        ForcesDock dock = on(() -> new ForcesDock(session));
        EventThread.run(() -> dock.checkBox(Muscle.MUSCLE).doClick());
        assertThat(on(() -> session.scenario().get(Muscle.MUSCLE))).isFalse();
        assertThat(on(() -> session.edits().undoPresentationName())).hasValue("Undo Muscle off");
        EventThread.run(() -> session.edits().undo());
        EventThread.until(
                "the box is ticked", () -> dock.checkBox(Muscle.MUSCLE).isSelected());
    }

    /** A click on a box without effect would pass for a force switched off. */
    @Test
    void aForceThatTheMaterialLacksCannotBeSwitched() {
        Session own = on(() -> new Session(FIRST));
        try {
            ForcesDock dock = on(() -> new ForcesDock(own));
            assertThat(on(() -> dock.checkBox(WallContact.CONTACT).isEnabled())).isTrue();
            for (String material : List.of("paper", "published")) {
                EventThread.run(() -> own.changeSeparately(
                        EditName.of("Material " + material), List.of(Assignment.read("test", "material", material))));
                EventThread.run(() -> dock.onChange());
                for (Setting<?> lacking : List.of(WallContact.CONTACT, TransdiaphragmaticPressure.PRESSURE)) {
                    assertThat(on(() -> dock.checkBox(lacking).isEnabled())).isFalse();
                    assertThat(on(() -> dock.checkBox(lacking).isSelected())).isFalse();
                }
                assertThat(on(() -> dock.checkBox(Muscle.MUSCLE).isEnabled())).isTrue();
                EventThread.run(() -> own.edits().undo());
                EventThread.run(() -> dock.onChange());
            }
            assertThat(on(() -> dock.checkBox(WallContact.CONTACT).isEnabled())).isTrue();
            assertThat(on(() -> dock.checkBox(WallContact.CONTACT).isSelected()))
                    .isTrue();
        } finally {
            EventThread.run(own::close);
        }
    }

    @Test
    void thePlotSavesTheColumnsOfARun(@TempDir Path folder) throws Exception {
        PlotDock dock = on(() -> new PlotDock(session));
        EventThread.run(() -> dock.trackPoint(0, 100));
        double from = session.live().status().timeS();
        EventThread.until("something was plotted", () -> session.live().status().timeS() > from + 0.5);
        EventThread.run(() -> {
            dock.onTick(session.live().status());
            dock.saveCsv(folder.resolve("samples.csv"));
        });
        List<String> lines = Files.readAllLines(folder.resolve("samples.csv"));
        List<String> header = Arrays.asList(lines.get(0).split(","));
        assertThat(header.subList(0, Observation.COLUMNS.size())).isEqualTo(Observation.COLUMNS);
        assertThat(header).hasSize(Observation.COLUMNS.size() + 1).endsWith("point_1_up_mm");
        assertThat(lines).hasSizeGreaterThan(20);
    }

    /** A fifth point takes the row of the first, whose box may be empty. */
    @Test
    void aPointThatIsPickedIsDrawnThoughAnEarlierOneWasHidden() {
        PlotDock dock = on(() -> new PlotDock(session));
        List<String> labels = new ArrayList<>();
        for (int i = 0; i < 4; i++) {
            int vertex = 100 * i;
            labels.add(on(() -> dock.trackPoint(0, vertex)).orElseThrow());
        }
        assertThat(labels).containsExactly("Point 1", "Point 2", "Point 3", "Point 4");
        JCheckBox first = WindowHarness.find(dock, JCheckBox.class, "Point 1").orElseThrow();
        EventThread.run(() -> first.setSelected(false));
        assertThat(on(() -> dock.trackPoint(0, 500))).hasValue("Point 1");
        assertThat(on(first::isSelected)).isTrue();
    }

    @Test
    void theBreathIsShadedBehindTheCurves() {
        PlotDock dock = on(() -> new PlotDock(session));
        double from = session.live().status().timeS();
        EventThread.until("a breath and more", () -> session.live().status().timeS() > from + 2.5);
        EventThread.run(() -> dock.onTick(session.live().status()));
        EventThread.run(dock::draw);
        CombinedDomainXYPlot plots = (CombinedDomainXYPlot) dock.chart().getXYPlot();
        List<Paint> shades = new ArrayList<>();
        EventThread.run(() -> {
            for (Object marker : plots.getSubplots().get(0).getDomainMarkers(Layer.BACKGROUND)) {
                shades.add(((IntervalMarker) marker).getPaint());
            }
        });
        assertThat(shades)
                .contains(PhaseColours.of(RespiratoryPhase.INSPIRATION), PhaseColours.of(RespiratoryPhase.EXPIRATION))
                .doesNotContain(PhaseColours.of(RespiratoryPhase.PAUSE));
    }

    @Test
    void scrubbingStandsStillAndLiveGoesOn() {
        TimelineDock dock = on(() -> new TimelineDock(session));
        EventThread.until(
                "some frames are recorded", () -> session.live().history().frames() > 5);
        EventThread.run(() -> dock.stepFrames(-3));
        assertThat(on(() -> session.historyFrame())).isPresent();
        assertThat(session.live().isPlaying()).isFalse();
        EventThread.run(() -> dock.stepFrames(Integer.MAX_VALUE));
        assertThat(on(() -> session.historyFrame())).isEmpty();
        assertThat(session.live().isPlaying()).isTrue();
    }

    /** A sample comes every 0.02 s: the pause, and a step in it, come between two of them. */
    @Test
    void theTimelineSaysThatTheRunIsPausedAtTheMomentOfTheStatusBar() {
        TimelineDock dock = on(() -> new TimelineDock(session));
        EventThread.run(() -> {
            dock.onTick(session.live().status());
            session.live().pause();
        });
        EventThread.until("it is paused", () -> !session.live().status().playing());
        requireMoment(dock);
        long before = session.live().status().step();
        EventThread.run(session.live()::stepOnce);
        EventThread.until("it has stepped", () -> session.live().status().step() > before);
        requireMoment(dock);
    }

    private static void requireMoment(TimelineDock dock) {
        RunStatus now = session.live().status();
        EventThread.run(() -> dock.onTick(now));
        String moment = Numbers.format("%.2f s, paused", now.timeS());
        assertThat(on(() -> WindowHarness.find(dock, JLabel.class, moment))).isPresent();
    }

    @Test
    void settingsAreStoredRestoredAndComparedWhileItBreathes(@TempDir Path folder) {
        ScenarioStore store = new ScenarioStore(folder);
        String[] name = {"as it was"};
        SettingsDock dock = on(() -> settings(store, name, question -> false, new PlotDock(session)));
        EventThread.run(dock::save);
        long scene = on(() -> session.scene().orElseThrow().id());
        EventThread.run(() -> session.change("Depth", Assignment.read("test", "depth", "1.3")));
        name[0] = "deeper";
        EventThread.run(dock::save);
        assertThat(store.names()).containsExactly("as it was", "deeper");
        EventThread.run(dock::swap);
        assertThat(on(() -> session.scenario().get(Breathing.DEPTH))).isEqualTo(1);
        EventThread.run(dock::swap);
        assertThat(on(() -> session.scenario().get(Breathing.DEPTH))).isEqualTo(1.3);
        assertThat(on(() -> session.scene().orElseThrow().id())).isEqualTo(scene);
    }

    @Test
    void settingsAreRestoredAndDeletedOnlyWhereSomeAreSelected(@TempDir Path folder) {
        SettingsDock dock = on(() ->
                settings(new ScenarioStore(folder), new String[] {"one"}, question -> true, new PlotDock(session)));
        for (String name : List.of("Restore", "Delete")) {
            JButton button = WindowHarness.find(dock, JButton.class, name).orElseThrow();
            assertThat(button.isEnabled()).as(name).isFalse();
            EventThread.run(dock::save);
            assertThat(button.isEnabled()).as(name).isTrue();
            EventThread.run(dock::delete);
            assertThat(button.isEnabled()).as(name).isFalse();
        }
    }

    @Test
    void settingsThatCannotBeReadAreNotSaidToBePresent(@TempDir Path folder) throws Exception {
        ScenarioStore store = new ScenarioStore(folder);
        String[] name = {"one"};
        SettingsDock dock = on(() -> settings(store, name, question -> false, new PlotDock(session)));
        EventThread.run(dock::save);
        name[0] = "other";
        EventThread.run(dock::save);
        try (Stream<Path> files = Files.list(folder)) {
            for (Path file : files.toList()) {
                Files.delete(file);
            }
        }
        EventThread.run(dock::swap);
        assertThat(on(() -> dock.comparison())).doesNotContain("Now");
    }

    private static SettingsDock settings(
            ScenarioStore store, String[] name, Predicate<String> confirms, PlotDock plots) {
        return new SettingsDock(session, store, () -> Optional.of(name[0]), confirms, plots);
    }

    @Test
    void storedSettingsAreReplacedAndDeletedOnlyOnAYes(@TempDir Path folder) {
        ScenarioStore store = new ScenarioStore(folder);
        boolean[] yes = {false};
        List<String> asked = new ArrayList<>();
        SettingsDock dock = on(() -> settings(
                store,
                new String[] {"mine "},
                question -> {
                    asked.add(question);
                    return yes[0];
                },
                new PlotDock(session)));
        EventThread.run(dock::save);
        assertThat(asked).isEmpty();
        EventThread.run(() -> {
            session.change("Depth", Assignment.read("test", "depth", "1.3"));
            dock.save();
            dock.delete();
        });
        assertThat(asked).hasSize(2);
        assertThat(store.load("mine").get(Breathing.DEPTH)).isEqualTo(1);
        yes[0] = true;
        EventThread.run(dock::save);
        assertThat(store.load("mine").get(Breathing.DEPTH)).isEqualTo(1.3);
        EventThread.run(dock::delete);
        assertThat(store.names()).isEmpty();
    }

    private static void breathe(double seconds) {
        // What has changed before is known to all when this is read.
        double from = on(() -> session.live().status().timeS());
        EventThread.until("it has breathed", () -> session.live().status().timeS() > from + seconds);
    }

    /** Two settings of which the second, the present one, is deeper. */
    private static SettingsDock withShallowAndDeeper(Path folder, PlotDock plots) {
        String[] name = {"shallow"};
        SettingsDock dock = on(() -> settings(new ScenarioStore(folder), name, question -> false, plots));
        EventThread.run(dock::save);
        EventThread.run(() -> session.change("Depth", Assignment.read("test", "depth", "1.3")));
        name[0] = "deeper";
        EventThread.run(dock::save);
        return dock;
    }

    /** Breaths take 1.5 s: after 3.5 s one has been whole. */
    @Test
    void theBreathThatIsLeftStaysInThePlotAndIsComparedWithThePresentOne(@TempDir Path folder) {
        PlotDock plots = on(() -> new PlotDock(session));
        SettingsDock dock = withShallowAndDeeper(folder, plots);
        assertThat(on(() -> dock.firstChoice().getSelectedItem())).isEqualTo("shallow");
        assertThat(on(() -> dock.secondChoice().getSelectedItem())).isEqualTo("deeper");
        EventThread.run(dock::swap);
        breathe(4);
        EventThread.run(() -> plots.onTick(session.live().status()));
        EventThread.run(dock::swap);
        breathe(4);
        EventThread.run(() -> plots.onTick(session.live().status()));
        EventThread.run(() -> dock.onTick(session.live().status()));
        BreathComparison comparison = on(() -> plots.comparison().orElseThrow());
        assertThat(comparison.keptName()).isEqualTo("A: shallow");
        assertThat(comparison.rows()).hasSize(3).allSatisfy(row -> {
            assertThat(row.kept()).isPositive();
            // Drives of 1.3 times the depth move everything further.
            assertThat(row.difference()).as(row.label()).isGreaterThan(0.1 * row.kept());
        });
        CombinedDomainXYPlot chart = (CombinedDomainXYPlot) plots.chart().getXYPlot();
        int overlaid = on(() -> {
            plots.draw();
            XYDataset data = ((XYPlot) chart.getSubplots().get(0)).getDataset();
            return data.getItemCount(data.indexOf("Dome right overlay"));
        });
        assertThat(overlaid).isGreaterThan(20);
    }

    @Test
    void theBreathThatIsLeftHasNoNameOfSettingsThatWereLeftBefore(@TempDir Path folder) {
        PlotDock plots = on(() -> new PlotDock(session));
        SettingsDock dock = withShallowAndDeeper(folder, plots);
        EventThread.run(dock::swap);
        EventThread.run(() -> session.change("Depth", Assignment.read("test", "depth", "1.2")));
        EventThread.until(
                "what is said of the settings is gone", () -> !dock.comparison().contains("shallow"));
        breathe(4);
        EventThread.run(() -> plots.onTick(session.live().status()));
        EventThread.run(dock::swap);
        breathe(4);
        EventThread.run(() -> plots.onTick(session.live().status()));
        assertThat(on(() -> plots.comparison().orElseThrow().keptName())).isEqualTo("the settings before");
    }

    @Test
    void settingsThatArePresentAlreadyLeaveNothingToUndo(@TempDir Path folder) {
        SettingsDock dock = on(() ->
                settings(new ScenarioStore(folder), new String[] {"mine"}, question -> false, new PlotDock(session)));
        EventThread.run(dock::save);
        EventThread.run(dock::restore);
        assertThat(on(() -> session.edits().undoPresentationName())).isEmpty();
    }

    @Test
    void aSliderShowsTheValueOfTheScenarioWhenItIsReleased() {
        ParameterDock dock = on(() -> new ParameterDock(session));
        SliderRow row = row(dock, "depth");
        EventThread.run(() -> {
            row.slider().setValueIsAdjusting(true);
            row.slider().setValue(SliderScale.POSITIONS);
        });
        EventThread.until("the value is sent", () -> session.scenario().get(Breathing.DEPTH) == 2);
        EventThread.run(session.edits()::undo);
        EventThread.run(() -> {});
        EventThread.run(() -> {
            row.slider().setValueIsAdjusting(false);
            assertThat(row.field().getText()).isEqualTo("1");
        });
    }

    @Test
    void aBodyWhoseFolderIsGoneIsRefused(@TempDir Path folder) {
        String gone = folder.resolve("gone").toString();
        List<String> said = new ArrayList<>();
        Session.Listener ear = new MessageListener(said::add);
        ParameterDock dock = on(() -> new ParameterDock(session));
        ChoiceRow body = (ChoiceRow)
                dock.rows().stream().filter(r -> r.isFor("anatomy")).findFirst().orElseThrow();
        EventThread.run(() -> {
            session.addListener(ear);
            body.comboBox().addItem(gone);
            body.comboBox().setSelectedItem(gone);
            session.removeListener(ear);
        });
        assertThat(said).singleElement().asString().contains(gone);
        assertThat(on(() -> body.comboBox().getSelectedItem())).isEqualTo("virtual/adult-male");
    }

    /** Writes breaths of 4 s, in samples of 0.1 s. */
    private static Path recording(Path file, int samples) throws IOException {
        StringBuilder csv = new StringBuilder("time_s,amplitude\n");
        for (int i = 0; i <= samples; i++) {
            csv.append(i / 10.0).append(',').append(-Math.cos(Math.PI * i / 20)).append('\n');
        }
        return Files.writeString(file, csv);
    }

    @Test
    void aTraceSaysWhatWasReadAndDisablesTheRate(@TempDir Path folder) throws Exception {
        Path file = recording(folder.resolve("mine.csv"), 200);
        BreathDock dock = on(() -> new BreathDock(session));
        EventThread.run(() -> dock.openTrace(file));
        EventThread.until("the trace is taken", () -> session.scenario().trace().isPresent());
        EventThread.run(dock::onChange);
        awaitDescription(dock, "5 breaths");
        assertThat(on(() -> dock.traceDescription().getText())).contains("column amplitude", "4.0 s each");
        assertThat(on(() -> dock.row(Breathing.RATE).slider().isEnabled())).isFalse();
        assertThat(on(() -> dock.row(Breathing.RATE).message())).contains("recorded breath");
        assertThat(on(() -> dock.row(Breathing.DEPTH).slider().isEnabled())).isTrue();
        recording(file, 160);
        EventThread.run(() -> dock.onScene(session.scene().orElseThrow()));
        awaitDescription(dock, "4 breaths");
        recording(file, 120);
        EventThread.run(() -> dock.openTrace(file));
        awaitDescription(dock, "3 breaths");
        // As another scenario does, whose scene is told before its values.
        EventThread.run(() -> {
            session.edits().undo();
            session.edits().undo();
            dock.onScene(session.scene().orElseThrow());
        });
        EventThread.until(
                "the rate is back", () -> dock.row(Breathing.RATE).slider().isEnabled());
        EventThread.until(
                "nothing is said of a trace", () -> !dock.traceDescription().isVisible());
    }

    /** A recording of hours takes seconds to read. */
    @Test
    void aPresetThatIsChosenWhileATraceIsReadStays(@TempDir Path folder) throws Exception {
        Path file = recording(folder.resolve("long.csv"), 20_000);
        BreathDock dock = on(() -> new BreathDock(session));
        EventThread.run(() -> {
            dock.openTrace(file);
            dock.selectPreset("deep");
        });
        Assignment.read("test", Breathing.TRACE.key(), file.toString());
        breathe(1);
        assertThat(on(() -> session.scenario().trace())).isEmpty();
        assertThat(on(() -> session.scenario().preset())).isEqualTo("deep");
    }

    /** Of the file as it is now. */
    private static void awaitDescription(BreathDock dock, String part) {
        EventThread.until(
                part,
                () -> dock.traceDescription().getText().contains(part)
                        && dock.traceDescription().isVisible());
    }

    @Test
    void aTraceThatDoesNotBreatheIsRefusedInOneSentence(@TempDir Path folder) throws Exception {
        Path flat = Files.writeString(
                folder.resolve("flat.csv"),
                "time_s,amplitude\n"
                        + IntStream.range(0, 9).mapToObj(i -> i + ",1\n").collect(Collectors.joining()));
        Scenario breathing = Scenario.defaults().with(Breathing.TRACE, Optional.of(flat));
        assertThatExceptionOfType(BadInputException.class)
                .isThrownBy(() -> Breathing.traceDescription(breathing))
                .withMessageContaining("flat.csv: the signal stays at 1.0");
        List<String> said = new ArrayList<>();
        BreathDock dock = on(() -> new BreathDock(session));
        Session.Listener ear = new MessageListener(said::add);
        EventThread.run(() -> {
            session.addListener(ear);
            dock.openTrace(flat);
        });
        EventThread.until("a refusal", () -> !said.isEmpty());
        EventThread.run(() -> session.removeListener(ear));
        assertThat(said).singleElement().asString().contains("flat.csv: the signal stays at 1.0, expected breathing");
    }

    @Test
    void beyondTheStabilityLimitTheRowsSaySoInWords() {
        ParameterDock dock = on(() -> new ParameterDock(session));
        SliderRow row = row(dock, "time_step_s");
        assertThat(row.message()).isEmpty();
        EventThread.run(() -> {
            row.field().setText("0.02");
            row.field().postActionEvent();
        });
        EventThread.until("steps are split", () -> session.live().status().substeps() > 1);
        EventThread.run(() -> dock.onTick(session.live().status()));
        assertThat(row.message())
                .startsWith("Runs with ")
                .contains("because the time step 0.02 s is beyond the stability limit");
    }

    private static DisplayDock showDock(AppearanceModel looks, Path file) {
        DisplayDock dock = new DisplayDock(session, looks, () -> Optional.ofNullable(file));
        session.scene().ifPresent(scene -> looks.setSurfaces(scene.surfaces()));
        return dock;
    }

    @SuppressWarnings("unchecked")
    private static JComboBox<String> colours(DisplayDock dock) {
        return WindowHarness.find(dock, JComboBox.class, "Colours show").orElseThrow();
    }

    @Test
    void distancesAreMeasuredFromTheSurfaceThatIsChosen(@TempDir Path folder) {
        Path scan = folder.resolve("scan.stl");
        MeshFiles.write(scan, new TriangleMesh(new double[] {0, 0, 0, 9, 0, 0, 0, 9, 0}, new int[] {0, 1, 2}));
        AppearanceModel looks = on(AppearanceModel::new);
        DisplayDock dock = on(() -> showDock(looks, scan));
        EventThread.run(() -> colours(dock).setSelectedItem("Distance to a surface"));
        EventThread.until("the surface is read", () -> looks.style().field() == ColourField.DISTANCE);
        assertThat(looks.reference()).isPresent();
        assertThat(looks.style().scale().unit()).isEqualTo("mm");
    }

    @Test
    void aSurfaceThatCannotBeReadIsRefusedInOneSentenceAndNothingIsColoured(@TempDir Path folder) throws Exception {
        Path broken = Files.writeString(folder.resolve("scan.stl"), "solid nothing");
        List<String> told = new ArrayList<>();
        Session.Listener listener = new MessageListener(told::add);
        AppearanceModel looks = on(AppearanceModel::new);
        DisplayDock dock = on(() -> showDock(looks, broken));
        EventThread.run(() -> session.addListener(listener));
        EventThread.run(() -> colours(dock).setSelectedItem("Distance to a surface"));
        EventThread.until("it is refused", () -> !told.isEmpty());
        assertThat(told).singleElement().asString().contains("scan.stl");
        assertThat(on(() -> colours(dock).getSelectedItem())).isEqualTo("No colours");
        assertThat(looks.style().field()).isEqualTo(ColourField.NONE);
        EventThread.run(() -> session.removeListener(listener));
    }

    /** A large file is read for seconds: what is chosen meanwhile is what the user wants. */
    @Test
    void aSurfaceThatIsReadChangesNothingThatWasChosenMeanwhile(@TempDir Path folder) throws Exception {
        Path broken = Files.writeString(folder.resolve("broken.stl"), "solid nothing");
        Path scan = folder.resolve("scan.stl");
        MeshFiles.write(scan, new TriangleMesh(new double[] {0, 0, 0, 9, 0, 0, 0, 9, 0}, new int[] {0, 1, 2}));
        List<String> told = new ArrayList<>();
        Session.Listener listener = new MessageListener(told::add);
        AppearanceModel looks = on(AppearanceModel::new);
        List<Path> files = new ArrayList<>(List.of(scan, broken, scan, broken));
        DisplayDock dock = on(() -> new DisplayDock(session, looks, () -> Optional.of(files.remove(0))));
        JButton other = WindowHarness.find(dock, JButton.class, "Surface to measure from")
                .orElseThrow();
        EventThread.run(() -> {
            session.addListener(listener);
            looks.setSurfaces(session.scene().orElseThrow().surfaces());
            dock.onScene(session.scene().orElseThrow());
            colours(dock).setSelectedItem("Distance to a surface");
            other.doClick();
            colours(dock).setSelectedItem(ColourField.STRAIN.label());
        });
        EventThread.until("the second is refused", () -> !told.isEmpty());
        assertThat(on(() -> colours(dock).getSelectedItem())).isEqualTo(ColourField.STRAIN.label());
        assertThat(looks.reference()).isEmpty();
        assertThat(other.getText()).isEqualTo("Surface...");
        EventThread.run(() -> colours(dock).setSelectedItem("Distance to a surface"));
        EventThread.until("the surface is read", () -> looks.style().field() == ColourField.DISTANCE);
        EventThread.run(other::doClick);
        EventThread.until("the next is refused", () -> told.size() == 2);
        assertThat(other.getText()).as("what distances are measured from").isEqualTo("scan.stl...");
        assertThat(looks.style().field()).isEqualTo(ColourField.DISTANCE);
        EventThread.run(() -> session.removeListener(listener));
    }

    @Test
    void theDefaultAppearanceTakesTheControlsBackToo() {
        AppearanceModel looks = on(AppearanceModel::new);
        DisplayDock dock = on(() -> showDock(looks, null));
        JCheckBox springs = WindowHarness.find(dock, JCheckBox.class, "Springs").orElseThrow();
        JComboBox<?> clip =
                WindowHarness.find(dock, JComboBox.class, "Clip plane").orElseThrow();
        EventThread.run(() -> {
            springs.doClick();
            clip.setSelectedIndex(1);
            colours(dock).setSelectedIndex(1);
        });
        assertThat(looks.style().lines().overlays()).isNotEmpty();
        assertThat(looks.style().clip()).isPresent();
        assertThat(looks.style().field()).isEqualTo(ColourField.DISPLACEMENT);
        EventThread.run(looks::reset);
        assertThat(springs.isSelected()).isFalse();
        assertThat(clip.getSelectedIndex()).isZero();
        assertThat(on(() -> colours(dock).getSelectedItem())).isEqualTo("No colours");
        assertThat(looks.style().clip()).isEmpty();
        assertThat(looks.style().field()).isEqualTo(ColourField.NONE);
    }

    /** Sternum and ribs move forward beyond all that is there at rest. */
    @Test
    void atTheLeftEndAClipPlaneCutsNothingAwayInADeepBreath() {
        AppearanceModel looks = on(AppearanceModel::new);
        DisplayDock dock = on(() -> showDock(looks, null));
        JComboBox<?> clip =
                WindowHarness.find(dock, JComboBox.class, "Clip plane").orElseThrow();
        JSlider slider = WindowHarness.find(dock, JSlider.class, "Place of the clip plane")
                .orElseThrow();
        EventThread.run(() -> {
            clip.setSelectedIndex(clip.getItemCount() - 2);
            slider.setValue(0);
            session.change("Deep", Assignment.read("test", "preset", "deep"));
        });
        assertThat(clip.getSelectedItem()).hasToString("From the front");
        double planeMm = -looks.style().clip().orElseThrow().offsetMm();
        breathe(3.5);
        assertThat(on(DocksTest::foremostMm)).isGreaterThan(planeMm);
    }

    /** The foremost place of a rigid surface in the recorded frames, LPS, mm. */
    private static double foremostMm() {
        LiveScene scene = session.scene().orElseThrow();
        Frame frame = scene.newFrame().get();
        double foremost = Double.POSITIVE_INFINITY;
        for (int f = 0; f < session.live().history().frames(); f++) {
            session.live().history().frame(f, frame);
            for (int s = 0; s < scene.surfaces().size(); s++) {
                Surface surface = scene.surfaces().get(s);
                double[] rest = surface.rest().positions();
                for (int k = 0; surface.motion() == Surface.Motion.RIGID && k < rest.length; k += 3) {
                    float[] p = frame.pose(s);
                    foremost = Math.min(foremost, p[4] * rest[k] + p[5] * rest[k + 1] + p[6] * rest[k + 2] + p[7]);
                }
            }
        }
        return foremost;
    }

    /** @param temporary whether the field has the focus again afterwards, as when another window was looked at */
    private static void loseFocus(JTextField field, boolean temporary, Component to) {
        for (FocusListener listener : field.getFocusListeners()) {
            listener.focusLost(new FocusEvent(field, FocusEvent.FOCUS_LOST, temporary, to));
        }
    }

    @Test
    void aNumberIsTakenWhenItsFieldIsLeftAndNotWhenTheWindowIs() {
        BreathDock dock = on(() -> new BreathDock(session));
        EventThread.run(() -> {
            JTextField field = dock.row(Breathing.DEPTH).field();
            double before = session.scenario().get(Breathing.DEPTH);
            field.setText("0.7");
            loseFocus(field, true, null);
            dock.onChange();
            assertThat(session.scenario().get(Breathing.DEPTH)).isEqualTo(before);
            assertThat(field.getText()).as("whatever changes meanwhile").isEqualTo("0.7");
            loseFocus(field, false, null);
            assertThat(session.scenario().get(Breathing.DEPTH)).isEqualTo(0.7);
        });
    }

    /** Such a menu may save the values, or a key may that leaves the field in focus. */
    @Test
    void aNumberIsTakenWhenAMenuOfItsWindowIsOpenedAndBeforeACommand() {
        BreathDock dock = on(() -> new BreathDock(session));
        EventThread.run(() -> {
            JTextField field = dock.row(Breathing.DEPTH).field();
            field.setText("0.7");
            loseFocus(field, true, dock);
            assertThat(session.scenario().get(Breathing.DEPTH)).isEqualTo(0.7);
            field.setText("0.8");
            TypedText.take(field);
            assertThat(session.scenario().get(Breathing.DEPTH)).isEqualTo(0.8);
            TypedText.take(dock);
            TypedText.take(null);
        });
    }

    @Test
    void aRangeOfColoursIsTakenWhenItsFieldIsLeft() {
        AppearanceModel looks = on(AppearanceModel::new);
        DisplayDock dock = on(() -> showDock(looks, null));
        JTextField end = WindowHarness.find(dock, JTextField.class, "Greatest value of the colours")
                .orElseThrow();
        EventThread.run(() -> {
            colours(dock).setSelectedIndex(1);
            end.setText("1");
            loseFocus(end, true, null);
            assertThat(looks.style().scale().max()).as("in the midst of it").isNotEqualTo(1);
            end.setText("12,5 mm");
            loseFocus(end, false, null);
        });
        assertThat(looks.style().scale().max()).isEqualTo(12.5);
    }

    /** The dock at the right is no narrower. */
    @Test
    void presetsAreWholeInANarrowDock() {
        EventThread.run(() -> {
            Theme.install(false);
            BreathDock dock = new BreathDock(session);
            dock.setSize(300, 400);
            for (int i = 0; i < 2; i++) {
                layOut(dock);
            }
            for (String name : BreathingPreset.names()) {
                JToggleButton button = dock.presetButton(name);
                int right = SwingUtilities.convertPoint(button, button.getWidth(), 0, dock).x;
                assertThat(right).as(name).isLessThan(300);
                assertThat(button.getWidth()).as(name).isGreaterThanOrEqualTo(button.getPreferredSize().width);
            }
        });
    }

    private static void layOut(Container part) {
        part.invalidate();
        part.doLayout();
        Stream.of(part.getComponents()).filter(Container.class::isInstance).forEach(child -> layOut((Container) child));
    }

    @Test
    void whoChoosesNoSurfaceSeesNoColours() {
        AppearanceModel looks = on(AppearanceModel::new);
        DisplayDock dock = on(() -> showDock(looks, null));
        EventThread.run(() -> colours(dock).setSelectedItem("Distance to a surface"));
        assertThat(on(() -> colours(dock).getSelectedItem())).isEqualTo("No colours");
    }

    @Test
    void whoChoosesNoSurfaceKeepsTheColoursThatAreShown(@TempDir Path folder) throws Exception {
        AppearanceModel looks = on(AppearanceModel::new);
        Path broken = Files.writeString(folder.resolve("scan.stl"), "solid nothing");
        List<Optional<Path>> answers = new ArrayList<>(List.of(Optional.empty(), Optional.of(broken)));
        DisplayDock dock = on(() -> new DisplayDock(session, looks, () -> answers.remove(0)));
        EventThread.run(() -> {
            looks.setSurfaces(session.scene().orElseThrow().surfaces());
            dock.onScene(session.scene().orElseThrow());
            colours(dock).setSelectedItem(ColourField.DISPLACEMENT.label());
            JTextField most = WindowHarness.find(dock, JTextField.class, "Greatest value of the colours")
                    .orElseThrow();
            most.setText("12");
            most.postActionEvent();
        });
        for (String how : List.of("cancelled", "refused")) {
            EventThread.run(() -> colours(dock).setSelectedItem("Distance to a surface"));
            EventThread.until(
                    how,
                    () -> ColourField.DISPLACEMENT.label().equals(colours(dock).getSelectedItem()));
            assertThat(looks.style().field()).as(how).isEqualTo(ColourField.DISPLACEMENT);
            assertThat(looks.style().scale().max()).as(how).isEqualTo(12);
        }
    }
}
