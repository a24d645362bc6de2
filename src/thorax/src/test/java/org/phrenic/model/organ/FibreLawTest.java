package org.phrenic.model.organ;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.assertj.core.api.Assertions.withinPercentage;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.phrenic.anatomy.Diaphragm;
import org.phrenic.anatomy.DomeSheet;
import org.phrenic.anatomy.OpposingVertices;
import org.phrenic.mesh.CotangentWeights;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.MeshTopology;
import org.phrenic.mesh.TriangleMesh;

/** Shares by which springs of muscle shorten, and their stiffness along the sheet and across the tendon's border. */
class FibreLawTest {

    /**
     * A strain E changes the length of an edge with unit direction n by n·E n. With fibres along x, the edges of a
     * triangle of any shape and orientation ask for E = -diag(7/8, -1/8): the three shares fit one tensor.
     */
    @Test
    void theEdgesOfEveryTriangleAskForOneStrain() {
        Random random = new Random(7);
        double[] fibre = {1, 0, 0};
        for (int k = 0; k < 20; k++) {
            double[] p = new double[9];
            for (int i = 0; i < 3; i++) {
                p[3 * i] = random.nextGaussian();
                p[3 * i + 1] = random.nextGaussian();
            }
            for (int i = 0; i < 3; i++) {
                int j = (i + 1) % 3;
                double dx = p[3 * j] - p[3 * i];
                double dy = p[3 * j + 1] - p[3 * i + 1];
                double shortened = (7 * dx * dx - dy * dy) / 8 / (dx * dx + dy * dy);
                assertThat(MuscleStrain.inTriangle(p, i, j, fibre, 0)).isCloseTo(shortened, within(1e-12));
            }
        }
    }

    /**
     * Struts ask for the strain of the muscle that they cross. A strut of direction d through a level sheet with fibres
     * along x shortens by (7/8 dx² - 1/8 dy²) / |d|²; one that stands upright keeps its length.
     */
    @Test
    void strutsAskForTheStrainOfTheMuscleAboutThem() {
        Diaphragm dome = Diaphragm.withTrefoilTendon(DomeSheet.adult(30));
        MuscleStrain strain = new MuscleStrain(dome);
        double[] p = dome.sheet().positions();
        double[] fibre = dome.fibreDirections();
        double[] normals = MeshMeasure.triangleNormals(dome.sheet());
        double squares = 0;
        int compared = 0;
        for (OpposingVertices.Pair pair : OpposingVertices.of(dome, 20).nearestPairs(2)) {
            int triangle = dome.topology().vertexTriangles()[dome.topology().vertexTriangleStart()[pair.a()]];
            if (fibre[3 * triangle] == 0 || dome.distanceFromInsertion(pair.a()) < 40 || isNearTendon(dome, pair)) {
                continue;
            }
            double along = 0;
            double out = 0;
            double squared = 0;
            for (int k = 0; k < 3; k++) {
                double d = p[3 * pair.b() + k] - p[3 * pair.a() + k];
                along += d * fibre[3 * triangle + k];
                out += d * normals[3 * triangle + k];
                squared += d * d;
            }
            double across = squared - along * along - out * out;
            double difference = strain.alongStrut(pair.a(), pair.b()) - (7 * along * along - across) / 8 / squared;
            squares += difference * difference;
            compared++;
        }
        assertThat(compared).isGreaterThan(100);
        // Fibres and normals turn from cell to cell by some degrees.
        assertThat(Math.sqrt(squares / compared)).isLessThan(0.05);
    }

    private static boolean isNearTendon(Diaphragm dome, OpposingVertices.Pair pair) {
        MeshTopology topology = dome.topology();
        for (int v : new int[] {pair.a(), pair.b()}) {
            for (int k = topology.vertexEdgeStart()[v]; k < topology.vertexEdgeStart()[v + 1]; k++) {
                if (dome.isTendon(topology.otherVertex(topology.vertexEdges()[k], v))) {
                    return true;
                }
            }
        }
        return false;
    }

    /**
     * A network of springs is equally stiff along any two perpendicular directions if Σ k l² cos 2φ and Σ k l² sin 2φ
     * over its edges are 0; with k = 3/4 E h cot α they are, for a triangle of any shape.
     */
    @Test
    void aTriangleOfAnyShapeIsEquallyStiffInPerpendicularDirections() {
        Random random = new Random(11);
        for (int n = 0; n < 20; n++) {
            double[] p = new double[9];
            for (int i = 0; i < 3; i++) {
                p[3 * i] = random.nextGaussian();
                p[3 * i + 1] = random.nextGaussian();
            }
            TriangleMesh one = new TriangleMesh(p, new int[] {0, 1, 2});
            MeshTopology topology = new MeshTopology(one);
            double[] weights = CotangentWeights.of(one, topology);
            double even = 0;
            double odd = 0;
            double trace = 0;
            for (int e = 0; e < 3; e++) {
                int a = topology.edges()[2 * e];
                int b = topology.edges()[2 * e + 1];
                double dx = p[3 * b] - p[3 * a];
                double dy = p[3 * b + 1] - p[3 * a + 1];
                double k = TissueLaw.membrane(300, 3).edgeStiffness(2 * Math.sqrt(3) * weights[e], 1);
                even += k * (dx * dx - dy * dy);
                odd += k * 2 * dx * dy;
                trace += k * (dx * dx + dy * dy);
            }
            assertThat(even).isCloseTo(0, within(1e-9 * Math.abs(trace)));
            assertThat(odd).isCloseTo(0, within(1e-9 * Math.abs(trace)));
            // Equilateral triangles have Σ k l² = 3 E h A; a face has half of E h.
            assertThat(trace).isCloseTo(3 * 150 * MeshMeasure.area(one), within(1e-9 * Math.abs(trace)));
        }
    }

    /** Struts carry part of the stiffness along the sheet; edges and struts together are as stiff on every mesh. */
    @Test
    void edgesAndStrutsTogetherAreAsStiffAsTheSheet() {
        for (int rings : new int[] {12, 20, 30}) {
            Diaphragm dome = Diaphragm.withTrefoilTendon(DomeSheet.adult(rings));
            double[] noCrura = new double[dome.sheet().vertexCount()];
            TissueLaw law = TissueLaw.membrane(300, 3);
            MassSpringBuilder parts = new MassSpringBuilder();
            new DiaphragmPart(dome, new DiaphragmPart.Tissue(law, 1, 1, true, noCrura, 1, 1), parts);
            double energy =
                    stretchEnergy(dome, parts.sheetSprings, dome.topology().edgeCount());
            // Edges of slivers at the seam count for more than their cotangents: 4 % on every mesh.
            assertThat(energy).isCloseTo(1.044 * 3 * 150 * MeshMeasure.area(dome.sheet()), withinPercentage(0.5));
        }
    }

    /** Σ k (s² / l)² of edges and struts, s the length along the sheet: energy of a strain equal in all directions. */
    private static double stretchEnergy(Diaphragm dome, SpringList springs, int edges) {
        double[] normals = MeshMeasure.vertexNormals(dome.sheet());
        double[] p = dome.sheet().positions();
        double sum = 0;
        for (int i = 0; i < springs.count(); i++) {
            double squared = 0;
            double out = 0;
            double normal = 0;
            int a = springs.nodeA()[i];
            int b = springs.nodeB()[i];
            for (int k = 0; k < 3; k++) {
                double d = p[3 * b + k] - p[3 * a + k];
                squared += d * d;
                double mean = normals[3 * a + k] - normals[3 * b + k];
                out += d * mean;
                normal += mean * mean;
            }
            double across = i < edges ? 0 : out * out / normal;
            sum += springs.stiffness()[i] * (squared - across) * (squared - across) / squared;
        }
        return sum;
    }

    @Test
    void edgesWithoutFibresDoNotShorten() {
        assertThat(MuscleStrain.inTriangle(new double[] {0, 0, 0, 1, 0, 0}, 0, 1, new double[3], 0))
                .isZero();
    }

    /** Half of an edge in tissue ten times as stiff: compliances 1/20 and 1/2 add. */
    @Test
    void anEdgeAcrossTheBorderIsTendonAndMuscleInSeries() {
        assertThat(DiaphragmPart.inSeries(0, 10)).isEqualTo(1);
        assertThat(DiaphragmPart.inSeries(0.5, 10)).isCloseTo(1 / 0.55, within(1e-12));
        assertThat(DiaphragmPart.inSeries(1, 10)).isEqualTo(10);
    }
}
