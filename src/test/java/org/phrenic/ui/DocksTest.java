package org.phrenic.ui;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.data.Percentage.withPercentage;

import java.awt.Paint;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.concurrent.atomic.AtomicReference;
import java.util.stream.Stream;
import javax.swing.JComboBox;
import org.jfree.chart.plot.CombinedDomainXYPlot;
import org.jfree.chart.plot.IntervalMarker;
import org.jfree.chart.ui.Layer;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.phrenic.breathing.BreathLabel;
import org.phrenic.breathing.BreathingPreset;
import org.phrenic.format.MeshFiles;
import org.phrenic.geometry.TriangleMesh;
import org.phrenic.scene.ColourField;
import org.phrenic.simulation.Assignment;
import org.phrenic.simulation.Choice;
import org.phrenic.simulation.Material;
import org.phrenic.simulation.Observation;
import org.phrenic.simulation.Parameter;
import org.phrenic.simulation.Scenario;
import org.phrenic.simulation.live.History;

/** The docks over a simulation that really runs: the coarse sheet alone, which breathes as the whole scene does. Needs no display. */
class DocksTest {
    private static final Scenario FIRST = Scenario.defaults()
            .with("resolution=low", "lungs=embedded", "sternum=kinematic", "liver=false", "rate_per_min=40");
    private static final int DOME = Observation.COLUMNS.indexOf("dome_right_mm");

    private static Session session;

    @BeforeAll
    static void begin() {
        session = Edt.get(() -> new Session(FIRST));
        Edt.until("the scene is there", () -> session.scene().isPresent());
        session.live().setSpeed(Double.POSITIVE_INFINITY);
    }

    @AfterAll
    static void end() {
        Edt.run(session::close);
    }

    @BeforeEach
    void asAtFirst() {
        Edt.run(() -> {
            session.follow();
            session.live().play();
            while (session.edits().undoName().isPresent()) {
                session.edits().undo();
            }
        });
        Edt.until("the first settings are back", () -> session.scenario().equals(FIRST));
    }

    private static <T> T on(Callable<T> what) {
        return Edt.get(what);
    }

    private static ValueRow row(ParameterDock dock, String key) {
        return (ValueRow)
                dock.rows().stream().filter(r -> r.isFor(key)).findFirst().orElseThrow();
    }

    @Test
    void everyParameterHasARowAndNothingElseHas() {
        ParameterDock dock = on(() -> new ParameterDock(session));
        List<String> choices = Stream.of(
                        Choice.MATERIAL,
                        Choice.ANATOMY,
                        Choice.RESOLUTION,
                        Choice.TIME_STEP,
                        Choice.INTEGRATOR,
                        Choice.THREADS)
                .map(Choice::key)
                .toList();
        List<String> keys =
                Stream.concat(choices.stream(), Parameter.keys().stream()).toList();
        assertThat(dock.rows()).hasSameSizeAs(keys);
        assertThat(keys).allSatisfy(key -> assertThat(dock.rows()).anyMatch(row -> row.isFor(key)));
    }

    @Test
    void rowsOfTheMaterialAreShownAndASearchNarrowsThem() {
        ParameterDock dock = on(() -> new ParameterDock(session));
        for (Parameter parameter : Parameter.values()) {
            assertThat(row(dock, parameter.key()).isVisible()).isEqualTo(parameter.isUsedBy(Material.PHYSICAL));
        }
        Edt.run(() -> dock.search().setText("tendon stiff"));
        assertThat(dock.rows().stream().filter(SettingRow::isVisible))
                .hasSizeBetween(1, 3)
                .contains(row(dock, "tendon_stiffness_ratio"));
    }

    @Test
    void aRowNamesItselfForScreenReaders() {
        ParameterDock dock = on(() -> new ParameterDock(session));
        for (Parameter parameter : Parameter.values()) {
            ValueRow row = row(dock, parameter.key());
            assertThat(row.field().getAccessibleContext().getAccessibleName()).isEqualTo(parameter.label());
            assertThat(row.slider().getAccessibleContext().getAccessibleName()).isEqualTo(parameter.label());
            assertThat(row.field().getToolTipText()).contains(parameter.key());
        }
    }

    @Test
    void whatIsTypedBeyondTheRangeIsSetToItsEndAndSaidSo() {
        ParameterDock dock = on(() -> new ParameterDock(session));
        ValueRow row = row(dock, "muscle_stiffness_n_per_m");
        Edt.run(() -> {
            row.field().setText("9000");
            row.field().postActionEvent();
        });
        assertThat(on(() -> session.scenario().value(Parameter.MUSCLE_STIFFNESS)))
                .isEqualTo(3000);
        assertThat(row.field().getText()).isEqualTo("3000");
        // So stiff a sheet splits steps, which the row has to say too; what was typed comes first.
        Edt.until("steps are split", () -> session.live().status().substeps() > 1);
        Edt.run(() -> {
            dock.onTick(session.live().status());
            dock.onChange();
        });
        assertThat(row.hintText()).isEqualTo("9000 N/m is out of range; the largest, 3000 N/m, is taken.");
        Edt.run(() -> {
            row.field().setText("stiff");
            row.field().postActionEvent();
        });
        assertThat(row.field().getText()).isEqualTo("3000");
        assertThat(row.hintText()).isEqualTo("Found 'stiff', expected a number from 30 to 3000 N/m.");
        Edt.run(() -> row.resetButton().doClick());
        assertThat(on(() -> session.scenario().value(Parameter.MUSCLE_STIFFNESS)))
                .isEqualTo(300);
        assertThat(row.resetButton().isEnabled()).isFalse();
        assertThat(row.hintText()).doesNotContain("stiff'");
    }

    @Test
    void draggingIsOneChangeToUndo() {
        ParameterDock dock = on(() -> new ParameterDock(session));
        ValueRow row = row(dock, "depth");
        Edt.run(() -> {
            row.slider().setValueIsAdjusting(true);
            for (int place = SliderScale.PLACES / 2; place <= SliderScale.PLACES; place++) {
                row.slider().setValue(place);
            }
            row.slider().setValueIsAdjusting(false);
        });
        assertThat(on(() -> session.scenario().value(Parameter.DEPTH))).isEqualTo(2);
        assertThat(on(() -> session.edits().undoName())).hasValue("Undo Depth 1 -> 2");
        Edt.run(() -> session.edits().undo());
        assertThat(on(() -> session.scenario().value(Parameter.DEPTH))).isEqualTo(1);
        Edt.until("the row shows it", () -> row.field().getText().equals("1"));
    }

    @Test
    void resetAllIsOneChange() {
        ParameterDock dock = on(() -> new ParameterDock(session));
        Edt.run(() -> session.change(
                "Two at once", new Assignment("test", "depth", "1.5"), new Assignment("test", "rib_rotation", "0.5")));
        Edt.run(dock::resetAll);
        Scenario now = on(() -> session.scenario());
        assertThat(now.value(Parameter.DEPTH)).isEqualTo(1);
        assertThat(now.value(Parameter.RIB_ROTATION)).isEqualTo(1);
        assertThat(now.value(Parameter.RATE)).isEqualTo(15);
        Edt.run(() -> session.edits().undo());
        assertThat(on(() -> session.scenario().value(Parameter.DEPTH))).isEqualTo(1.5);
    }

    /** Deepest that the right dome goes in the next two breaths after half a second, mm. */
    private static double excursion() {
        double from = session.live().status().timeS() + 0.5;
        Edt.until("two breaths have passed", () -> session.live().status().timeS() > from + 3.2);
        History history = session.live().history();
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
        Edt.run(() -> session.change("Depth 1 -> 0.3", new Assignment("test", "depth", "0.3")));
        double shallow = excursion();
        Edt.run(() -> session.edits().undo());
        double after = excursion();
        assertThat(before).isGreaterThan(5);
        assertThat(shallow).isLessThan(0.6 * before);
        assertThat(after).isCloseTo(before, withPercentage(5));
    }

    @Test
    void aPresetButtonBreathesByItAndHoldsStopTheBreath() {
        BreathDock dock = on(() -> new BreathDock(session));
        for (String name : BreathingPreset.names()) {
            assertThat(dock.presetButton(name).getToolTipText()).contains(name);
        }
        Edt.run(() -> dock.presetButton("deep").doClick());
        Scenario deep = on(() -> session.scenario());
        assertThat(deep.preset()).isEqualTo("deep");
        // The rate that was set by hand gives way to that of the preset.
        assertThat(deep.value(Parameter.RATE))
                .isEqualTo(deep.breathing().parameters().ratePerMin());
        Edt.run(() -> dock.holdButton().doClick());
        assertThat(on(() -> session.scenario().hold())).isTrue();
        Edt.run(() -> session.edits().undo());
        Edt.run(() -> session.edits().undo());
        assertThat(on(() -> session.scenario())).isEqualTo(FIRST);
        Edt.until("the button is up", () -> !dock.holdButton().isSelected());
    }

    @Test
    void aFileThatIsNoTraceIsRefusedInOneSentence(@TempDir Path folder) throws Exception {
        Path bad = Files.writeString(folder.resolve("bad.csv"), "hello,world\n1,2\n");
        AtomicReference<String> said = new AtomicReference<>();
        Session.Events ear = new Session.Events() {
            @Override
            public void onMessage(Session.Message message) {
                said.set(message.text());
            }
        };
        Edt.run(() -> {
            session.listen(ear);
            new BreathDock(session).openTrace(bad);
            session.forget(ear);
        });
        assertThat(said.get()).contains("bad.csv").contains("time_s,amplitude");
        assertThat(on(() -> session.scenario().trace())).isEmpty();
    }

    @Test
    void aForceIsSwitchedOffAndOn() {
        ForcesDock dock = on(() -> new ForcesDock(session));
        Edt.run(() -> dock.box(Choice.MUSCLE).doClick());
        assertThat(on(() -> session.scenario().muscle())).isFalse();
        assertThat(on(() -> session.edits().undoName())).hasValue("Undo Muscle off");
        Edt.run(() -> session.edits().undo());
        Edt.until("the box is ticked", () -> dock.box(Choice.MUSCLE).isSelected());
    }

    @Test
    void thePlotSavesTheColumnsOfARun(@TempDir Path folder) throws Exception {
        PlotDock dock = on(() -> new PlotDock(session));
        Edt.run(() -> dock.track(0, 100));
        double from = session.live().status().timeS();
        Edt.until("something was plotted", () -> session.live().status().timeS() > from + 0.5);
        Edt.run(() -> {
            dock.onTick(session.live().status());
            dock.saveCsv(folder.resolve("samples.csv"));
        });
        List<String> lines = Files.readAllLines(folder.resolve("samples.csv"));
        List<String> header = Arrays.asList(lines.get(0).split(","));
        assertThat(header.subList(0, Observation.COLUMNS.size())).isEqualTo(Observation.COLUMNS);
        assertThat(header).hasSize(Observation.COLUMNS.size() + 1).endsWith("point_1_up_mm");
        assertThat(lines).hasSizeGreaterThan(20);
    }

    @Test
    void theBreathIsShadedBehindTheCurves() {
        PlotDock dock = on(() -> new PlotDock(session));
        double from = session.live().status().timeS();
        Edt.until("a breath and more", () -> session.live().status().timeS() > from + 2.5);
        Edt.run(() -> dock.onTick(session.live().status()));
        Edt.run(dock::draw);
        CombinedDomainXYPlot plots = (CombinedDomainXYPlot) dock.chart().getXYPlot();
        List<Paint> shades = new ArrayList<>();
        Edt.run(() -> {
            for (Object marker : plots.getSubplots().get(0).getDomainMarkers(Layer.BACKGROUND)) {
                shades.add(((IntervalMarker) marker).getPaint());
            }
        });
        assertThat(shades)
                .contains(PhaseColours.of(BreathLabel.INSPIRATION), PhaseColours.of(BreathLabel.EXPIRATION))
                .doesNotContain(PhaseColours.of(BreathLabel.PAUSE));
    }

    @Test
    void scrubbingStandsStillAndLiveGoesOn() {
        TimelineDock dock = on(() -> new TimelineDock(session));
        Edt.until("some frames are recorded", () -> session.live().history().frames() > 5);
        Edt.run(() -> dock.go(-3));
        assertThat(on(() -> session.scrubbed())).isPresent();
        assertThat(session.live().isPlaying()).isFalse();
        Edt.run(() -> dock.go(Integer.MAX_VALUE));
        assertThat(on(() -> session.scrubbed())).isEmpty();
        assertThat(session.live().isPlaying()).isTrue();
    }

    @Test
    void settingsAreStoredRestoredAndComparedWhileItBreathes(@TempDir Path folder) {
        ScenarioStore store = new ScenarioStore(folder);
        String[] name = {"as it was"};
        SettingsDock dock = on(() -> new SettingsDock(session, store, () -> Optional.of(name[0])));
        Edt.run(dock::save);
        long scene = on(() -> session.scene().orElseThrow().id());
        Edt.run(() -> session.change("Depth", new Assignment("test", "depth", "1.3")));
        name[0] = "deeper";
        Edt.run(dock::save);
        assertThat(store.names()).containsExactly("as it was", "deeper");
        Edt.run(dock::swap);
        assertThat(on(() -> session.scenario().value(Parameter.DEPTH))).isEqualTo(1);
        Edt.run(dock::swap);
        assertThat(on(() -> session.scenario().value(Parameter.DEPTH))).isEqualTo(1.3);
        assertThat(on(() -> session.scene().orElseThrow().id())).isEqualTo(scene);
    }

    @Test
    void beyondTheStabilityLimitTheRowsSaySoInWords() {
        ParameterDock dock = on(() -> new ParameterDock(session));
        ValueRow row = row(dock, "time_step_s");
        assertThat(row.hintText()).isEmpty();
        Edt.run(() -> {
            row.field().setText("0.02");
            row.field().postActionEvent();
        });
        Edt.until("steps are split", () -> session.live().status().substeps() > 1);
        Edt.run(() -> dock.onTick(session.live().status()));
        assertThat(row.hintText())
                .startsWith("Runs with ")
                .contains("because the time step 0.02 s is beyond the stability limit");
    }

    private static ShowDock showDock(Looks looks, Path file) {
        ShowDock dock = new ShowDock(session, looks, () -> Optional.ofNullable(file));
        session.scene().ifPresent(scene -> looks.scene(scene.surfaces()));
        return dock;
    }

    @SuppressWarnings("unchecked")
    private static JComboBox<String> colours(ShowDock dock) {
        return WindowHarness.find(dock, JComboBox.class, "Colours show").orElseThrow();
    }

    @Test
    void distancesAreMeasuredFromTheSurfaceThatIsChosen(@TempDir Path folder) {
        Path scan = folder.resolve("scan.stl");
        MeshFiles.write(scan, new TriangleMesh(new double[] {0, 0, 0, 9, 0, 0, 0, 9, 0}, new int[] {0, 1, 2}));
        Looks looks = on(Looks::new);
        ShowDock dock = on(() -> showDock(looks, scan));
        Edt.run(() -> colours(dock).setSelectedItem("Distance to a surface"));
        Edt.until("the surface is read", () -> looks.style().field() == ColourField.DISTANCE);
        assertThat(looks.reference()).isPresent();
        assertThat(looks.style().scale().unit()).isEqualTo("mm");
    }

    @Test
    void aSurfaceThatCannotBeReadIsRefusedInOneSentenceAndNothingIsColoured(@TempDir Path folder) throws Exception {
        Path broken = Files.writeString(folder.resolve("scan.stl"), "solid nothing");
        List<String> told = new ArrayList<>();
        Session.Events listener = new Session.Events() {
            @Override
            public void onMessage(Session.Message message) {
                told.add(message.text());
            }
        };
        Looks looks = on(Looks::new);
        ShowDock dock = on(() -> showDock(looks, broken));
        Edt.run(() -> session.listen(listener));
        Edt.run(() -> colours(dock).setSelectedItem("Distance to a surface"));
        Edt.until("it is refused", () -> !told.isEmpty());
        assertThat(told).singleElement().asString().contains("scan.stl");
        assertThat(on(() -> colours(dock).getSelectedItem())).isEqualTo("No colours");
        assertThat(looks.style().field()).isEqualTo(ColourField.NONE);
        Edt.run(() -> session.forget(listener));
    }

    @Test
    void whoChoosesNoSurfaceSeesNoColours() {
        Looks looks = on(Looks::new);
        ShowDock dock = on(() -> showDock(looks, null));
        Edt.run(() -> colours(dock).setSelectedItem("Distance to a surface"));
        assertThat(on(() -> colours(dock).getSelectedItem())).isEqualTo("No colours");
    }
}
