package org.phrenic.anatomy.contact;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.phrenic.anatomy.DiaphragmSide;
import org.phrenic.anatomy.OrganNames;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.engine.math.Triangles;
import org.phrenic.mesh.MeshTopology;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.Vectors;
import org.phrenic.mesh.query.TriangleTree;
import org.phrenic.model.organ.DiaphragmPart;
import org.phrenic.model.organ.OrganSettings;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.Runs;
import org.phrenic.simulation.Simulation;
import org.phrenic.simulation.SimulationRun;

/** Organs about the virtual man's diaphragm, whose nodes are all lowered by 20 mm; its right dome is at z = 116 mm. */
class SheetContactTest {
    private static final double LOWERED_MM = 20;
    /** Frames of a short series from one that is compared with the same frame alone to the next. */
    private static final int COMPARED_EVERY = 3;
    /** Likewise of a long one; a point that is wrongly left out stays so for up to 12 of its frames. */
    private static final int COMPARED_EVERY_OF_MANY = 4;

    private static Simulation simulation;
    private static double[] lowered;
    private static Simulation remeshedFemale;

    private static SheetContact contactWith(DiaphragmPart part) {
        return new SheetContact(part.diaphragm, part.firstNode);
    }

    @BeforeAll
    static void lowerTheDiaphragm() {
        simulation = Runs.simulation(Runs.scenario(Runs.SHEET_ALONE));
        lowered = simulation.scene().restPositions().clone();
        for (int k = 2; k < lowered.length; k += 3) {
            lowered[k] -= LOWERED_MM;
        }
    }

    @AfterAll
    static void close() {
        simulation.close();
        if (remeshedFemale != null) {
            remeshedFemale.close();
        }
    }

    /** A liver that stands still is 20 mm through the lowered dome: its top yields to 2 mm, its lower part stays. */
    @Test
    void organsYieldToTheFaceOfTheirSideAlone() {
        SheetContact contact = contactWith(simulation.scene().diaphragm());
        contact.update(lowered);
        double[] liver = {-68, -16, 108, -68, -16, 60};
        contact.organ(liver, false).pushBack(liver);
        // The abdominal face lies at about 115 - 20 mm here.
        assertThat(liver[2]).isCloseTo(97, within(1.0));
        assertThat(liver[5]).isEqualTo(60);
        double[] lung = {-68, -16, 100, -68, -16, 85};
        contact.organ(lung, true).pushBack(lung);
        assertThat(lung[2]).isEqualTo(100);
        // The thoracic face lies at about 116 - 20 mm.
        assertThat(lung[5]).isCloseTo(94, within(1.0));
        contact.update(simulation.scene().restPositions());
        double[] atRest = {-68, -16, 108};
        contact.organ(atRest, false).pushBack(atRest);
        assertThat(atRest).containsExactly(-68, -16, 108);
    }

    /** A spleen that stands still, while the sheet beside it leaves the wall in a deep breath, lies 30 mm beyond. */
    @Test
    void anOrganFarBeyondTheSheetYieldsAsWell() {
        SheetContact contact = contactWith(simulation.scene().diaphragm());
        contact.update(lowered);
        double[] organ = {-68, -16, 128, -68, -16, 150};
        contact.organ(organ, false).pushBack(organ);
        assertThat(organ[2]).isCloseTo(97, within(2.0));
        assertThat(organ[5]).as("too far for the nearest point to say anything").isEqualTo(150);
    }

    /** The lowest row of the thoracic face, all of whose corners belong to triangles between the faces, has a side. */
    @Test
    void organsYieldBesideTheBorderAsWell() {
        Simulation female = remeshedFemale();
        DiaphragmPart part = female.scene().diaphragm();
        double[] nodes = female.scene().restPositions();
        int[] t = part.diaphragm.sheet().triangles();
        boolean[] atBorder = atBorder(part);
        SheetContact contact = contactWith(part);
        contact.update(nodes);
        int tried = 0;
        for (int i = 0; i < t.length; i += 3) {
            if (on(part, t, i) == 3 && atBorder[t[i]] && atBorder[t[i + 1]] && atBorder[t[i + 2]]) {
                assertYields(contact, outside(nodes, part.firstNode, t, i, 1, 1, 1));
                tried++;
            }
        }
        assertThat(tried).isPositive();
    }

    /**
     * A triangle of the thoracic face with two sides on the border has a third that is not, though both of its ends
     * are: an organ beside it has a side.
     */
    @Test
    void organsYieldBesideASideWithinAFaceWithBothEndsOnTheBorder() {
        Simulation female = remeshedFemale();
        DiaphragmPart part = female.scene().diaphragm();
        double[] nodes = female.scene().restPositions();
        int[] t = part.diaphragm.sheet().triangles();
        boolean[] atBorder = atBorder(part);
        MeshTopology topology = new MeshTopology(part.diaphragm.sheet());
        SheetContact contact = contactWith(part);
        contact.update(nodes);
        int tried = 0;
        for (int i = 0; i < t.length; i++) {
            int next = i % 3 == 2 ? i - 2 : i + 1;
            int across = 3 * topology.otherFace(topology.edgeOfSide()[i], i / 3);
            if (on(part, t, i - i % 3) == 3 && on(part, t, across) == 3 && atBorder[t[i]] && atBorder[t[next]]) {
                double[] weights = new double[3];
                weights[i % 3] = 1;
                weights[next % 3] = 1;
                assertYields(contact, outside(nodes, part.firstNode, t, i - i % 3, weights));
                tried++;
            }
        }
        assertThat(tried).isPositive();
    }

    /** At rest; two tests look at it and move nothing. */
    private static Simulation remeshedFemale() {
        if (remeshedFemale == null) {
            Scenario scenario =
                    Scenario.defaults().with("resolution=low").with("lungs=off").with("anatomy=virtual/adult-female");
            remeshedFemale = Simulation.of(
                    scenario,
                    Runs.withRemeshedSheet(
                            SimulationRun.loadThorax(scenario),
                            OrganSettings.budget(scenario).diaphragmVertices()));
        }
        return remeshedFemale;
    }

    /** The corners of triangles between the faces. */
    private static boolean[] atBorder(DiaphragmPart part) {
        int[] t = part.diaphragm.sheet().triangles();
        boolean[] atBorder = new boolean[part.diaphragm.sheet().vertexCount()];
        for (int i = 0; i < t.length; i++) {
            atBorder[t[i]] |= on(part, t, i - i % 3) % 3 != 0;
        }
        return atBorder;
    }

    private static int on(DiaphragmPart part, int[] t, int i) {
        int on = 0;
        for (int corner = i; corner < i + 3; corner++) {
            on += part.diaphragm.isThoracic(t[corner]) ? 1 : 0;
        }
        return on;
    }

    /** The point 0.5 mm outside a place on a triangle, the mean of its corners with these weights. */
    private static double[] outside(double[] nodes, int first, int[] t, int i, double... weights) {
        double[] normal = new double[3];
        Triangles.cross(nodes, 3 * (first + t[i]), 3 * (first + t[i + 1]), 3 * (first + t[i + 2]), normal);
        double length = Vectors.distance(normal, new double[3]);
        double sum = weights[0] + weights[1] + weights[2];
        double[] p = new double[3];
        for (int axis = 0; axis < 3; axis++) {
            p[axis] = 0.5 * normal[axis] / length;
            for (int corner = 0; corner < 3; corner++) {
                p[axis] += weights[corner] / sum * nodes[3 * (first + t[i + corner]) + axis];
            }
        }
        return p;
    }

    /** A point of an organ of the abdomen just above the thoracic face is moved down to the abdominal one. */
    private static void assertYields(SheetContact contact, double[] p) {
        double[] before = p.clone();
        contact.organ(p, false).pushBack(p);
        assertThat(Vectors.distance(p, before)).as("yield, mm").isGreaterThan(0.3);
    }

    /** Points all around the sheet, once as one organ and once each as an organ of its own. */
    @Test
    void aPointYieldsAsItDoesAlone() {
        SheetContact contact = contactWith(simulation.scene().diaphragm());
        contact.update(lowered);
        double[] points = aroundTheSheet(3000, 5);
        assertYieldsAsAlone(contact, points, false);
        assertYieldsAsAlone(contact, points, true);
    }

    /** Every other point is moved through the sheet after it was searched. */
    @Test
    void pointsThatAreMovedAfterTheyWereSearchedYieldWhereTheyAreThen() {
        SheetContact contact = contactWith(simulation.scene().diaphragm());
        contact.update(lowered);
        double[] points = aroundTheSheet(3000, 5);
        for (boolean above : new boolean[] {false, true}) {
            SheetContact.Organ organ = contact.organ(points, above);
            organ.pushBack(points.clone());
            double[] moved = points.clone();
            for (int k = 2; k < moved.length; k += 6) {
                moved[k] += above ? -8 : 8;
            }
            double[] expected = moved.clone();
            contact.organ(points, above).pushBack(expected);
            organ.pushBackAgain(moved);
            assertThat(moved).containsExactly(expected);
        }
    }

    /** A patch of the abdominal face bulges 8 mm upward, through the thoracic face; points lie within 4 mm of it. */
    @Test
    void pointsBesideAFoldThroughTheSheetYieldAsTheyDoAlone() {
        DiaphragmPart part = simulation.scene().diaphragm();
        double[] folded = simulation.scene().restPositions().clone();
        double[] patch = new double[folded.length];
        int n = 0;
        for (int v = 0; v < part.diaphragm.sheet().vertexCount(); v++) {
            int k = 3 * (part.firstNode + v);
            if (Math.hypot(folded[k] + 68, folded[k + 1] + 16) < 20 && folded[k + 2] > 100) {
                folded[k + 2] += part.diaphragm.isThoracic(v) ? 0 : 8;
                System.arraycopy(folded, k, patch, n, 3);
                n += 3;
            }
        }
        SheetContact contact = contactWith(part);
        contact.update(folded);
        Random random = new Random(7);
        double[] points = new double[3 * 1500];
        for (int k = 0; k < points.length; k += 3) {
            int near = 3 * random.nextInt(n / 3);
            for (int axis = 0; axis < 3; axis++) {
                points[k + axis] = patch[near + axis] + 4 / Math.sqrt(3) * (2 * random.nextDouble() - 1);
            }
        }
        assertYieldsAsAlone(contact, points, true);
        assertYieldsAsAlone(contact, points, false);
    }

    /** Points within 12 mm of pleats. */
    @Test
    void pointsBesidePleatsYieldAsTheyDoAlone() {
        SheetContact contact = contactWith(simulation.scene().diaphragm());
        contact.update(pleated());
        Random random = new Random(9);
        double[] points = new double[3 * 3000];
        for (int k = 0; k < points.length; k += 3) {
            points[k] = -68 + 60 * (random.nextDouble() - 0.5);
            points[k + 1] = -16 + 60 * (random.nextDouble() - 0.5);
            points[k + 2] = 112 + 24 * (random.nextDouble() - 0.5);
        }
        assertYieldsAsAlone(contact, points, true);
        assertYieldsAsAlone(contact, points, false);
    }

    /**
     * A point 24 mm above the dome, and the abdominal face bulging 15 mm through the thoracic one: the point lies
     * beyond its face, also after a frame in which it lay before it.
     */
    @Test
    void whatYieldsInAFoldDoesNotDependOnTheFrameBefore() {
        DiaphragmPart part = simulation.scene().diaphragm();
        double[] rest = simulation.scene().restPositions();
        double[] bulged = rest.clone();
        for (int v = 0; v < part.diaphragm.sheet().vertexCount(); v++) {
            int k = 3 * (part.firstNode + v);
            boolean inPatch = Math.hypot(rest[k] + 68, rest[k + 1] + 16) < 20 && rest[k + 2] > 100;
            bulged[k + 2] += inPatch && !part.diaphragm.isThoracic(v) ? 15 : 0;
        }
        double[] lung = {-68, -16, 140};
        double[] expected = lung.clone();
        SheetContact once = contactWith(part);
        once.update(bulged);
        once.organ(lung, true).pushBack(expected);
        assertThat(expected).isNotEqualTo(lung);

        SheetContact again = contactWith(part);
        SheetContact.Organ organ = again.organ(lung, true);
        again.update(rest);
        organ.pushBack(lung.clone());
        again.update(bulged);
        organ.pushBack(lung);
        assertThat(lung).containsExactly(expected);
    }

    /**
     * The sheet moves by 12 mm into an organ in 12 frames and is pleated meanwhile, until it passes through itself. Who
     * saw the frames before, or sees a frame twice, sees the organ of somebody who sees one frame alone.
     */
    @Test
    void anOrganIsDentedInAFrameAsItIsWithoutTheFramesBefore() {
        int dented = 0;
        for (Structure lung : simulation.scene().thorax().structuresOf(StructureKind.LUNG)) {
            dented += dentedInASeries(lung.mesh(), true) ? 1 : 0;
        }
        assertThat(dented).as("lungs that yield").isPositive();
        for (Structure liver : simulation.scene().thorax().structuresOf(StructureKind.LIVER)) {
            assertThat(dentedInASeries(liver.mesh(), false)).as("liver").isTrue();
        }
    }

    private static boolean dentedInASeries(TriangleMesh mesh, boolean above) {
        DiaphragmPart part = simulation.scene().diaphragm();
        double[] rest = simulation.scene().restPositions();
        double[] pleated = pleated();
        SheetContact series = contactWith(part);
        YieldingOrgan organ = new YieldingOrgan(series, mesh, above);
        double[] expected = {};
        for (int frame = 0; frame <= 12; frame++) {
            double[] nodes = rest.clone();
            for (int k = 0; k < nodes.length; k++) {
                double raised = k % 3 == 2 ? (above ? frame : -frame) : 0;
                nodes[k] += frame / 12.0 * (pleated[k] - rest[k]) + raised;
            }
            series.update(nodes);
            if (frame % COMPARED_EVERY != 0) {
                organ.dented(mesh.positions());
                continue;
            }
            SheetContact alone = contactWith(part);
            alone.update(nodes);
            expected = new YieldingOrgan(alone, mesh, above).dented(mesh.positions());
            assertThat(organ.dented(mesh.positions())).as("frame %d", frame).containsExactly(expected);
            assertThat(organ.dented(mesh.positions()))
                    .as("frame %d again", frame)
                    .containsExactly(expected);
        }
        return !Arrays.equals(expected, mesh.positions());
    }

    /** What lies before its own face, farther from it than the sheet is thick, is not drawn to pleats. */
    @Test
    void pointsBeforeTheirFaceStayWherePleatsPassThroughOneAnother() {
        DiaphragmPart part = simulation.scene().diaphragm();
        TriangleMesh sheet = part.diaphragm.sheet();
        double[] nodes = pleated();
        int first = 3 * part.firstNode;
        TriangleTree tree = new TriangleTree(
                sheet.withPositions(Arrays.copyOfRange(nodes, first, first + sheet.positions().length)));
        SheetContact contact = contactWith(part);
        contact.update(nodes);
        Random random = new Random(13);
        TriangleTree.Hit hit = new TriangleTree.Hit();
        int before = 0;
        for (int i = 0; i < 10_000; i++) {
            double[] p = {
                -68 + 80 * (random.nextDouble() - 0.5),
                -16 + 80 * (random.nextDouble() - 0.5),
                100 + 40 * (random.nextDouble() - 0.5)
            };
            tree.closest(p[0], p[1], p[2], hit);
            if (on(part, sheet.triangles(), 3 * hit.triangle) == 0 && hit.distanceSquared > 25) {
                double[] now = p.clone();
                contact.organ(now, false).pushBack(now);
                assertThat(now).containsExactly(p);
                before++;
            }
        }
        assertThat(before).isGreaterThan(2000);
    }

    /** Pleats 14 mm wide and tilted, which pass through one another. */
    private static double[] pleated() {
        DiaphragmPart part = simulation.scene().diaphragm();
        double[] pleated = simulation.scene().restPositions().clone();
        for (int v = 0; v < part.diaphragm.sheet().vertexCount(); v++) {
            int k = 3 * (part.firstNode + v);
            if (Math.hypot(pleated[k] + 68, pleated[k + 1] + 16) < 40 && pleated[k + 2] > 100) {
                double wave = Math.sin(2 * Math.PI * pleated[k] / 14);
                pleated[k] += 14 * wave;
                pleated[k + 2] += 7 * wave;
            }
        }
        return pleated;
    }

    /** The sheet goes down by 20 mm in 40 frames and is pleated meanwhile; points follow it by half. */
    @Test
    void pointsOfASeriesOfFramesYieldAsTheyDoInOneAlone() {
        DiaphragmPart part = simulation.scene().diaphragm();
        double[] rest = simulation.scene().restPositions();
        double[] at = aroundTheSheet(2000, 11);
        SheetContact series = contactWith(part);
        series.update(rest);
        for (boolean above : new boolean[] {true, false}) {
            SheetContact.Organ organ = series.organ(at, above);
            for (int frame = 0; frame <= 40; frame++) {
                double share = frame / 40.0;
                double[] nodes = rest.clone();
                double[] points = at.clone();
                for (int k = 0; k < nodes.length; k += 3) {
                    nodes[k + 2] -= share * (LOWERED_MM - 3 * Math.sin(2 * Math.PI * nodes[k] / 30));
                }
                for (int k = 2; k < points.length; k += 3) {
                    points[k] -= share * LOWERED_MM / 2;
                }
                series.update(nodes);
                double[] expected = points.clone();
                organ.pushBack(points);
                if (frame % COMPARED_EVERY_OF_MANY != 0) {
                    continue;
                }
                SheetContact alone = contactWith(part);
                alone.update(nodes);
                alone.organ(at, above).pushBack(expected);
                assertThat(points).as("frame %d", frame).containsExactly(expected);
            }
        }
    }

    private static double[] aroundTheSheet(int count, long seed) {
        double[] sheet = simulation.scene().diaphragm().diaphragm.sheet().positions();
        Random random = new Random(seed);
        double[] points = new double[3 * count];
        for (int k = 0; k < points.length; k += 3) {
            int near = 3 * random.nextInt(sheet.length / 3);
            for (int axis = 0; axis < 3; axis++) {
                points[k + axis] = sheet[near + axis] + 12 * random.nextGaussian();
            }
        }
        return points;
    }

    private static void assertYieldsAsAlone(SheetContact contact, double[] points, boolean above) {
        double[] together = points.clone();
        SheetContact.Organ organ = contact.organ(points, above);
        organ.pushBack(together);
        double[] again = points.clone();
        organ.pushBack(again);
        assertThat(again).as("from the triangles of the last search").containsExactly(together);
        int moved = 0;
        for (int k = 0; k < points.length; k += 3) {
            double[] alone = Arrays.copyOfRange(points, k, k + 3);
            contact.organ(alone, above).pushBack(alone);
            assertThat(Arrays.copyOfRange(together, k, k + 3)).containsExactly(alone);
            moved += Arrays.equals(alone, Arrays.copyOfRange(points, k, k + 3)) ? 0 : 1;
        }
        assertThat(moved).as("points that yield").isBetween(points.length / 30, 3 * points.length / 10);
    }

    @Test
    void sidesAreToldByName() {
        assertThat(List.of("kidney_L", "kidney", "organ_kidneys", "Small_Bowel", "organ_bowel"))
                .allMatch(name -> DiaphragmSide.of(StructureKind.ORGAN, name) == DiaphragmSide.BELOW);
        assertThat(DiaphragmSide.of(StructureKind.ORGAN, "heart")).isEqualTo(DiaphragmSide.ABOVE);
        assertThat(DiaphragmSide.of(StructureKind.ORGAN, OrganNames.STOMACH_IN_CHEST))
                .isEqualTo(DiaphragmSide.ABOVE);
        assertThat(DiaphragmSide.of(StructureKind.LUNG, "lung_R_middle")).isEqualTo(DiaphragmSide.ABOVE);
        assertThat(DiaphragmSide.of(StructureKind.VESSEL, "aorta")).isEqualTo(DiaphragmSide.NEITHER);
    }
}
