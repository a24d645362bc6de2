package org.phrenic.access.imaging;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.mesh.Shapes;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.SceneSurfaces;
import org.phrenic.simulation.Simulation;
import org.phrenic.simulation.SimulationRun;
import org.phrenic.simulation.observe.Frame;
import org.phrenic.simulation.observe.Surface;
import org.phrenic.simulation.observe.TestFrames;

class FluoroscopeTest {
    private static final CArm ARM = new CArm(new double[3], 0, 0, 1000, 700, new CArm.Detector(300, 65, 65));

    private static Surface surface(String name, StructureKind kind, TriangleMesh mesh) {
        return new Surface(name, kind, 0, Side.MIDLINE, mesh, Surface.Motion.STILL, new boolean[0]);
    }

    private static double central(List<Surface> surfaces) {
        return new Fluoroscope(surfaces, 1)
                .take(Frame.still(surfaces), ARM, Fluoroscope.ENERGY_KEV)
                .attenuation(32, 32);
    }

    /**
     * NIST at 60 keV: muscle 0.2048 cm2/g. Bone of 1.41 g/cm3 is 41 % cortical: 0.1 mm-1 x (0.59 x 1.05 x 0.2048 +
     * ...).
     */
    @Test
    void structuresReplaceTheTissueAroundThem() {
        Surface skin = surface("skin", StructureKind.SKIN, Shapes.sphere(100, 5));
        Surface rib = surface("rib_05_R", StructureKind.RIB, Shapes.sphere(20, 5));
        assertThat(central(List.of(skin))).isCloseTo(200 * 0.1 * 1.05 * 0.2048, within(0.01));
        double ribPerMm = 0.1 * (0.5862 * 1.05 * 0.2048 + 0.4138 * 1.92 * 0.3148);
        assertThat(central(List.of(skin, rib))).isCloseTo(160 * 0.1 * 1.05 * 0.2048 + 40 * ribPerMm, within(0.01));
        assertThat(central(List.of(rib))).isCloseTo(40 * ribPerMm, within(0.01));
    }

    /**
     * Surfaces of lungs and liver run around what lies in them. 200 mm of skin, 120 mm of organ, 30 mm of structure.
     */
    @ParameterizedTest
    @CsvSource({
        "lung_R, LUNG, lesion_nodule, LESION, LESION",
        "lung_R, LUNG, trachea, OTHER, GAS",
        "lung_R, LUNG, pulmonary_vein, VESSEL, BLOOD",
        "liver, LIVER, liver_lesion, LESION, LESION",
        "liver, LIVER, liver_vessels, VESSEL, BLOOD"
    })
    void whatLiesInAnOrganReplacesIt(String organ, StructureKind around, String name, StructureKind kind, Tissue own) {
        List<Surface> surfaces = List.of(
                surface("skin", StructureKind.SKIN, Shapes.sphere(100, 5)),
                surface(organ, around, Shapes.sphere(60, 5)),
                surface(name, kind, Shapes.sphere(15, 5)));
        double expected = 80 * Tissue.SOFT.attenuationPerMm(60)
                + 90 * Tissue.of(around, organ).attenuationPerMm(60)
                + 30 * own.attenuationPerMm(60);
        assertThat(central(surfaces)).isCloseTo(expected, within(0.01));
        assertThat(central(surfaces.subList(1, 3)))
                .as("without skin")
                .isCloseTo(expected - 80 * Tissue.SOFT.attenuationPerMm(60), within(0.01));
    }

    private static TriangleMesh insideOut(TriangleMesh mesh) {
        int[] triangles = mesh.triangles().clone();
        for (int t = 0; t < triangles.length; t += 3) {
            triangles[t] = mesh.triangles()[t + 1];
            triangles[t + 1] = mesh.triangles()[t];
        }
        return new TriangleMesh(mesh.positions(), triangles);
    }

    @Test
    void surfacesThatAreInsideOutDimAsOthersDo() {
        TriangleMesh body = Shapes.sphere(100, 5);
        TriangleMesh bone = Shapes.sphere(20, 5);
        double expected = central(
                List.of(surface("skin", StructureKind.SKIN, body), surface("rib_05_R", StructureKind.RIB, bone)));
        assertThat(central(List.of(
                        surface("skin", StructureKind.SKIN, insideOut(body)),
                        surface("rib_05_R", StructureKind.RIB, insideOut(bone)))))
                .isCloseTo(expected, within(1e-9));
    }

    /** The area of a ball goes with its height: a liver from there on has 70 % of one of 15 mm, or 30 %. */
    @ParameterizedTest
    @CsvSource({"-6, 1", "6, 0"})
    void aStructureReplacesAnOrganThatHasAtLeastHalfOfIt(double edgeMm, double share) {
        EnclosingOrgans liver = new EnclosingOrgans(List.of(halfSpaceFrom(edgeMm)));
        assertThat(liver.sharesOf(Shapes.sphere(15, 5))).containsExactly(share);
    }

    @Test
    void aStructureInTwoLungsReplacesEachByItsShare() {
        EnclosingOrgans lungs = new EnclosingOrgans(List.of(halfSpaceFrom(5), halfSpaceFrom(5 - 200)));
        double[] shares = lungs.sharesOf(Shapes.sphere(15, 5));
        assertThat(shares[0]).isCloseTo(1.0 / 3, within(0.03));
        assertThat(shares[1]).isCloseTo(2.0 / 3, within(0.03));
    }

    /** A box of 200 mm whose left face lies at x. */
    private static TriangleMesh halfSpaceFrom(double x) {
        return Shapes.moved(Shapes.box(200, 200, 200), x, -100, -100);
    }

    /** Tissue and blood of a lung, 1.2 kg as dense as soft tissue, take a part of the organ; 3.3 l are air. */
    @Test
    void aLungAtEndExpirationDimsAsItsTissueAloneDoesOverItsShareOfTheOrgan() {
        double tissueLitres = 1.2 / 1.05;
        double share = tissueLitres / (tissueLitres + 3.3);
        double soft = Tissue.SOFT.attenuationPerMm(60);
        assertThat(Tissue.LUNG.attenuationPerMm(60)).isCloseTo(share * soft, within(0.02 * share * soft));
    }

    /** A lung that is 1.5 times as wide in every direction has 1 / 3.375 of its density, about its nodule as well. */
    @Test
    void aNoduleReplacesTheLungOfTheMoment() {
        TriangleMesh rest = Shapes.sphere(40, 5);
        Surface lung = new Surface(
                "lung_R", StructureKind.LUNG, 0, Side.RIGHT, rest, Surface.Motion.DEFORMING, new boolean[0]);
        List<Surface> surfaces = List.of(lung, surface("lesion", StructureKind.LESION, Shapes.sphere(15, 5)));
        double[] filled = Arrays.stream(rest.positions()).map(x -> 1.5 * x).toArray();
        Frame frame = TestFrames.of(surfaces, 0, 0, 0, filled, new double[0]);
        double expected = 90 * Tissue.LUNG.attenuationPerMm(60) / 3.375 + 30 * Tissue.LESION.attenuationPerMm(60);
        assertThat(new Fluoroscope(surfaces, 1).take(frame, ARM, 60).attenuation(32, 32))
                .isCloseTo(expected, within(0.01));
    }

    /** A lesion of a bone, or of a kidney, lies in neither lung nor liver. */
    @Test
    void aLesionInNoOrganReplacesSoftTissue() {
        Surface skin = surface("skin", StructureKind.SKIN, Shapes.sphere(100, 5));
        Surface lesion = surface("lesion", StructureKind.LESION, Shapes.sphere(15, 5));
        double[] aside = Shapes.sphere(20, 5).positions().clone();
        for (int i = 0; i < aside.length; i += 3) {
            aside[i] += 60;
        }
        Surface liver =
                surface("liver", StructureKind.LIVER, Shapes.sphere(20, 5).withPositions(aside));
        double expected = 170 * Tissue.SOFT.attenuationPerMm(60) + 30 * Tissue.LESION.attenuationPerMm(60);
        assertThat(central(List.of(skin, liver, lesion))).isCloseTo(expected, within(0.01));
    }

    /** A needle of 2 mm across the central ray; iron at 60 keV: 1.205 cm2/g. */
    @Test
    void aNeedleAddsSteelToWhatItReplaces() {
        Surface skin = surface("skin", StructureKind.SKIN, Shapes.sphere(100, 4));
        SteelRod rod = new SteelRod(new double[] {-40, 0, 0}, new double[] {40, 0, 0}, 1);
        double with = new Fluoroscope(List.of(skin), 1)
                .take(Frame.still(List.of(skin)), ARM, Fluoroscope.ENERGY_KEV, List.of(rod))
                .attenuation(32, 32);
        double steelPerMm = 0.1 * (7.9 * 1.205 - 1.05 * 0.2048);
        assertThat(with - central(List.of(skin))).isCloseTo(2 * steelPerMm, within(0.02 * 2 * steelPerMm));
    }

    @Test
    void openSheetsAreLeftOutByName() {
        TriangleMesh box = Shapes.box(10, 10, 10);
        int[] face = Arrays.copyOf(box.triangles(), 6);
        List<Surface> surfaces = List.of(
                surface("liver", StructureKind.LIVER, new TriangleMesh(box.positions(), face)),
                surface("pleura_R", StructureKind.PLEURA, new TriangleMesh(box.positions(), face)),
                surface("lung_R", StructureKind.LUNG, box));
        assertThat(new Fluoroscope(surfaces, 1).leftOut()).containsExactly("liver");
    }

    /** The cap of a hole of one triangle is the triangle. */
    @Test
    void holesAreClosed() {
        TriangleMesh whole = Shapes.sphere(100, 4);
        int[] holed = Arrays.copyOf(whole.triangles(), whole.triangles().length - 3);
        List<Surface> closed = List.of(surface("skin", StructureKind.SKIN, whole));
        List<Surface> open = List.of(surface("skin", StructureKind.SKIN, new TriangleMesh(whole.positions(), holed)));
        for (double angle = 0; angle < 360; angle += 90) {
            CArm arm = new CArm(new double[3], angle, 20, 1000, 700, new CArm.Detector(300, 65, 65));
            Radiograph one = new Fluoroscope(closed, 1).take(Frame.still(closed), arm, Fluoroscope.ENERGY_KEV);
            Radiograph other = new Fluoroscope(open, 1).take(Frame.still(open), arm, Fluoroscope.ENERGY_KEV);
            for (int row = 0; row < 65; row++) {
                for (int column = 0; column < 65; column++) {
                    assertThat(other.attenuation(column, row)).isCloseTo(one.attenuation(column, row), within(1e-9));
                }
            }
        }
    }

    @Test
    void energiesOutsideTheTablesAreRefused() {
        assertThat(Tissue.SOFT.attenuationPerMm(50))
                .isBetween(Tissue.SOFT.attenuationPerMm(60), Tissue.SOFT.attenuationPerMm(40));
        assertThatThrownBy(() -> Tissue.SOFT.attenuationPerMm(120)).hasMessageContaining("40 to 80");
    }

    /** A source as high as the top of the right dome sees it on the middle row, before the breath and within it. */
    @Test
    void edgeOfTheDomeFollowsItsHeight() {
        Scenario scenario =
                Scenario.defaults().with("resolution=low", "lungs=embedded", "sternum=kinematic", "preset=deep");
        try (Simulation simulation = Simulation.of(scenario, SimulationRun.loadThorax(scenario))) {
            SceneSurfaces scene = new SceneSurfaces(simulation);
            Fluoroscope fluoroscope = new Fluoroscope(scene.surfaces(), 1);
            Frame frame = scene.newFrame();
            double before = edgeIsAtTheTopOfTheDome(fluoroscope, scene.surfaces(), frame);
            while (simulation.time() < 0.9) {
                simulation.step();
            }
            scene.capture(frame);
            assertThat(edgeIsAtTheTopOfTheDome(fluoroscope, scene.surfaces(), frame))
                    .isLessThan(before - 4);
        }
    }

    /** Returns the height of the dome, mm. */
    private static double edgeIsAtTheTopOfTheDome(Fluoroscope fluoroscope, List<Surface> surfaces, Frame frame) {
        int diaphragm = 0;
        while (surfaces.get(diaphragm).kind() != StructureKind.DIAPHRAGM) {
            diaphragm++;
        }
        TriangleMesh rest = surfaces.get(diaphragm).rest();
        double[] p = new double[rest.positions().length];
        frame.writePositions(surfaces.get(diaphragm), diaphragm, p);
        double[] top = {0, 0, -1000};
        for (int i = 0; i < p.length; i += 3) {
            if (p[i] < -30 && p[i + 2] > top[2]) {
                top = new double[] {p[i], p[i + 1], p[i + 2]};
            }
        }
        CArm arm = new CArm(top, 0, 0, 1000, 700, new CArm.Detector(200, 257, 257));
        PathLengths lengths = new PathLengths(arm, 1);
        lengths.add(rest.withPositions(p), 1);
        double[] values = lengths.values();
        int row = 0;
        while (values[row * arm.columns() + 128] == 0) {
            row++;
        }
        assertThat(row).isBetween(127, 129);
        Radiograph picture = fluoroscope.take(frame, arm, Fluoroscope.ENERGY_KEV);
        assertThat(picture.attenuation(128, row + 8))
                .as("brighter below the edge than above")
                .isGreaterThan(picture.attenuation(128, row - 3) + 0.2);
        return top[2];
    }
}
