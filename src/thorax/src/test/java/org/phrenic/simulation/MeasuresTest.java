package org.phrenic.simulation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import org.assertj.core.data.Percentage;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.phrenic.anatomy.Diaphragm;
import org.phrenic.anatomy.DomeSheet;
import org.phrenic.anatomy.Structure;
import org.phrenic.engine.kinematics.HelicalAxis;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.model.material.TransdiaphragmaticPressure;
import org.phrenic.model.organ.DiaphragmPart;
import org.phrenic.model.organ.MassSpringBuilder;
import org.phrenic.model.organ.TissueLaw;
import org.phrenic.simulation.observe.CageMeasure;
import org.phrenic.simulation.observe.FibreShortening;
import org.phrenic.simulation.observe.LungMeasure;
import org.phrenic.simulation.observe.Observation;
import org.phrenic.simulation.observe.SceneObserver;
import org.phrenic.simulation.observe.SheetPatch;

/**
 * What the observables say of motions whose answer is known: of a synthetic dome, and of the virtual body pushed about
 * by hand.
 */
class MeasuresTest {
    private static final double ROUNDING = 1e-9;

    private static Simulation simulation;
    private static DiaphragmPart dome;

    @BeforeAll
    static void make() {
        simulation = Runs.simulation(Runs.scenario("sternum=kinematic"));
        Diaphragm sheet = Diaphragm.withTrefoilTendon(DomeSheet.adult(12));
        double[] noCrura = new double[sheet.sheet().vertexCount()];
        TissueLaw law = TissueLaw.membrane(300, 60);
        dome = new DiaphragmPart(
                sheet, new DiaphragmPart.Tissue(law, 10, 1, true, noCrura, 1, 1), new MassSpringBuilder());
    }

    @AfterAll
    static void end() {
        simulation.close();
    }

    private static double[] scaled(double[] p, double factor) {
        double[] out = p.clone();
        for (int i = 0; i < out.length; i++) {
            out[i] *= factor;
        }
        return out;
    }

    @Test
    void aSheetShrunkToFourFifthsHasFibresAFifthShorter() {
        double[] rest = dome.diaphragm.sheet().positions();
        assertThat(new FibreShortening(dome, rest).shorteningPercent(scaled(rest, 0.8)))
                .isCloseTo(20, within(ROUNDING));
    }

    @Test
    void turningTheSheetShortensNoFibre() {
        double[] rest = dome.diaphragm.sheet().positions();
        double[] turned = rest.clone();
        HelicalAxis.through(new double[] {0.6, 0, 0.8}, new double[] {10, 20, 30}, 1.1, 5)
                .motion()
                .apply(turned);
        assertThat(new FibreShortening(dome, rest).shorteningPercent(turned)).isCloseTo(0, within(ROUNDING));
    }

    /** A fibre f of a sheet that is stretched along the axes by s is stretched by |s f|. */
    @Test
    void stretchingTheSheetAlongAnAxisShortensFibresByTheirDirections() {
        double[] rest = dome.diaphragm.sheet().positions();
        int[] triangles = dome.diaphragm.sheet().triangles();
        double[] fibres = dome.diaphragm.fibreDirections();
        double[] areas = new double[triangles.length / 3];
        Arrays.setAll(
                areas, t -> MeshMeasure.area(new TriangleMesh(rest, Arrays.copyOfRange(triangles, 3 * t, 3 * t + 3))));
        double[][] stretches = {{1, 1, 0.8}, {0.8, 1, 1}, {1, 0.8, 1}, {1.1, 0.9, 0.7}};
        for (double[] stretch : stretches) {
            double[] now = rest.clone();
            for (int i = 0; i < now.length; i++) {
                now[i] *= stretch[i % 3];
            }
            double sum = 0;
            double all = 0;
            for (int t = 0; t < triangles.length; t += 3) {
                double x = fibres[t];
                double y = fibres[t + 1];
                double z = fibres[t + 2];
                if (x != 0 || y != 0 || z != 0) {
                    sum += areas[t / 3] * Math.hypot(Math.hypot(stretch[0] * x, stretch[1] * y), stretch[2] * z);
                    all += areas[t / 3];
                }
            }
            assertThat(new FibreShortening(dome, rest).shorteningPercent(now))
                    .as("stretched by %s", Arrays.toString(stretch))
                    .isCloseTo(100 * (1 - sum / all), within(ROUNDING));
        }
    }

    @Test
    void aPatchTellsTheMeanMotionOfTheRoof() {
        double[] rest = dome.diaphragm.sheet().positions();
        double[] now = rest.clone();
        for (int i = 0; i < now.length; i++) {
            now[i] += new double[] {1, 2, -14}[i % 3];
        }
        SheetPatch patch = new SheetPatch(dome, -0.5, 0.33);
        assertThat(patch.displacement(rest, now, 2)).isCloseTo(-14, within(ROUNDING));
        assertThat(patch.displacement(rest, now, 0)).isCloseTo(1, within(ROUNDING));
    }

    @Test
    void movingClosedLungsAsAWholeTakesInNoAir() {
        double[] rest = simulation.scene().restPositions();
        double[] now = rest.clone();
        for (int i = 0; i < now.length; i++) {
            now[i] += new double[] {5, -3, -12}[i % 3];
        }
        LungMeasure lungs = new LungMeasure(simulation.scene());
        lungs.update(0, rest, now);
        assertThat(lungs.volumeChange()).isCloseTo(0, within(1e-6));
        lungs.update(0, rest, rest);
        assertThat(lungs.volumeChange()).isZero();
    }

    @Test
    void lungsThatGrowTakeInWhatTheirVolumeGrowsBy() {
        double[] rest = simulation.scene().restPositions();
        double volume = 0;
        for (Structure s : simulation.scene().lungs().orElseThrow().structures) {
            volume += MeshMeasure.signedVolume(s.mesh()) / 1000;
        }
        LungMeasure lungs = new LungMeasure(simulation.scene());
        lungs.update(0, rest, scaled(rest, 1.05));
        // The lungs have settled a little since they were meshed, by some millilitres.
        assertThat(lungs.volumeChange()).isCloseTo((1.05 * 1.05 * 1.05 - 1) * volume, Percentage.withPercentage(1));
    }

    @Test
    void atRestTheCageHasNotMoved() {
        simulation.scene().pose().update(0);
        CageMeasure cage =
                new CageMeasure(simulation.scene().thorax(), simulation.scene().pose());
        assertThat(cage.transverseChange()).isCloseTo(0, within(ROUNDING));
        assertThat(cage.sternumMotion()).containsExactly(new double[3], within(ROUNDING));
    }

    @Test
    void allObservablesAreZeroAtRestButTheDriveThatHoldsIt() {
        Observation rest = new SceneObserver(simulation.scene()).observe(0);
        for (String column : Observation.COLUMNS) {
            if (!column.equals("pressure_kpa")) {
                assertThat(rest.get(column)).as(column).isCloseTo(0, within(1e-9));
            }
        }
        assertThat(rest.get("pressure_kpa"))
                .isCloseTo(Runs.scenario().get(TransdiaphragmaticPressure.REST_PRESSURE), within(1e-12));
    }
}
