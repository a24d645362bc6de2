package org.phrenic.motion;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.stream.DoubleStream;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.document.CsvTable;
import org.phrenic.file.BadInputException;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.query.DistanceSummary;
import org.phrenic.mesh.query.TriangleTree;
import org.phrenic.mesh.voxel.VoxelBox;
import org.phrenic.simulation.Runs;
import org.phrenic.simulation.Simulation;

/** The motion of the coarse virtual man at the end of a quiet inspiration. */
class BodyMotionTest {
    /** Of a quiet breath at 30 a minute. */
    private static final double END_INSPIRATION_S = 0.8;

    private static final double EDGE_MM = 5;
    /** Nearer to lungs and diaphragm tissue is at a face that slides; one edge of the lattice of soft tissue. */
    private static final double AT_SLIDING_FACE_MM = 6;

    private static Simulation simulation;
    private static BodyMotion motion;
    private static MotionSampler sampler;
    private static VoxelBox box;

    @BeforeAll
    static void breathe() {
        simulation = Runs.simulation(Runs.scenario("rate_per_min=30"));
        motion = new BodyMotion(simulation, false, LungInside.VERTICES, 1);
        while (simulation.time() < END_INSPIRATION_S) {
            simulation.step();
        }
        motion.update();
        double[] b = motion.bounds();
        box = VoxelBox.covering(new double[] {b[0], b[1], b[2]}, new double[] {b[3], b[4], b[5]}, EDGE_MM);
        sampler = new MotionSampler(motion, box);
        sampler.update();
    }

    @AfterAll
    static void end() {
        motion.close();
        simulation.close();
    }

    private static double[] vertex(double[] positions, int v) {
        return Arrays.copyOfRange(positions, 3 * v, 3 * v + 3);
    }

    private static double distance(double[] a, double[] b) {
        return Math.sqrt((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]) + (a[2] - b[2]) * (a[2] - b[2]));
    }

    @Test
    void aBodyWithASkinNeedsNoNote() {
        assertThat(MotionExportTest.notes(simulation, motion)).isEmpty();
    }

    @Test
    void beyondItsReachOutsideTheBodyNothingMoves() {
        double[] b = motion.bounds();
        RegionField outside = motion.field(BodyRegions.OUTSIDE);
        double[] u = new double[3];
        boolean moves = false;
        for (double z = b[2]; z < b[5]; z += EDGE_MM) {
            for (double x = b[0]; x < b[3]; x += EDGE_MM) {
                outside.at(x, b[1] - BodyMotion.OUTSIDE_MM, z, u);
                assertThat(u).containsOnly(0);
                outside.at(x, b[1] - 0.5 * BodyMotion.OUTSIDE_MM, z, u);
                moves |= u[1] != 0;
            }
        }
        assertThat(moves).isTrue();
    }

    /** The skin of an inspired body lies before that of the body at rest. */
    @Test
    void theGridOfAnExportCoversTheInspiredBody() {
        double[] rest = motion.bounds();
        double[][] corners = MotionExport.corners(rest);
        double foremost = rest[1];
        for (int s = 0; s < motion.surfaces().size(); s++) {
            double[] now = motion.positions(s);
            for (int i = 0; i < now.length; i++) {
                assertThat(now[i]).isBetween(corners[0][i % 3], corners[1][i % 3]);
                foremost = i % 3 == 1 ? Math.min(foremost, now[i]) : foremost;
            }
        }
        assertThat(foremost).as("y of the foremost point, mm").isLessThan(rest[1] - 1);
    }

    @Test
    void verticesOfEverySurfaceGoWhereTheSimulationPutsThem() {
        for (int s = 0; s < motion.surfaces().size(); s++) {
            double[] rest = motion.surfaces().get(s).rest().positions();
            for (int v = 0; v < rest.length / 3; v += 5) {
                double[] moved = motion.moved(s, vertex(rest, v));
                assertThat(distance(moved, vertex(motion.positions(s), v)))
                        .as(motion.surfaces().get(s).name())
                        .isLessThan(1e-9);
            }
        }
    }

    /** A place on a lung's surface belongs to the lung, not to the wall beside it. */
    @Test
    void placesOnALungGoWithTheLung() {
        int lung = motion.structure("lung_R");
        double[] rest = motion.surfaces().get(lung).rest().positions();
        for (int v = 0; v < rest.length / 3; v += 97) {
            assertThat(distance(motion.moved(vertex(rest, v)), vertex(motion.positions(lung), v)))
                    .isLessThan(1e-9);
        }
    }

    @Test
    void bonesStayRigid() {
        int rib = motion.structure("rib_06_R");
        TriangleMesh mesh = motion.surfaces().get(rib).rest();
        double[] a = vertex(mesh.positions(), 0);
        double[] b = vertex(mesh.positions(), mesh.vertexCount() - 1);
        double[] middle = {0.7 * a[0] + 0.3 * b[0], 0.7 * a[1] + 0.3 * b[1], 0.7 * a[2] + 0.3 * b[2]};
        double[] movedA = motion.moved(rib, a);
        double[] movedMiddle = motion.moved(rib, middle);
        assertThat(distance(movedA, a)).isGreaterThan(0.01);
        assertThat(distance(movedA, motion.moved(rib, b))).isCloseTo(distance(a, b), within(1e-9));
        assertThat(distance(movedA, movedMiddle)).isCloseTo(distance(a, middle), within(1e-9));
    }

    /**
     * At vertices of the lungs beside ribs: the lung inside and the wall outside differ along the surface as the lung's
     * vertex and the rib differ; across it they stay together.
     */
    @Test
    void theJumpAcrossThePleuraIsTheSlipOfTheModel() {
        int lung = motion.structure("lung_R");
        TriangleMesh rest = motion.surfaces().get(lung).rest();
        TriangleMesh now = rest.withPositions(motion.positions(lung));
        double[] normals = MeshMeasure.vertexNormals(now);
        TriangleTree tree = new TriangleTree(now);
        TriangleTree.Hit hit = new TriangleTree.Hit();
        List<TriangleTree> trees =
                motion.surfaces().stream().map(s -> new TriangleTree(s.rest())).toList();
        int count = 0;
        double misses = 0;
        double slips = 0;
        for (int v = 0; v < rest.vertexCount(); v++) {
            double[] place = vertex(rest.positions(), v);
            int rib = ribBeside(trees, place);
            if (rib < 0) {
                continue;
            }
            double[] inside = motion.moved(lung, place);
            double[] outside = {0, 0, 0};
            motion.field(BodyRegions.WALL).at(place[0], place[1], place[2], outside);
            double[] bone = motion.moved(rib, place);
            double miss = 0;
            double slip = 0;
            double across = 0;
            for (int axis = 0; axis < 3; axis++) {
                across += (bone[axis] - inside[axis]) * normals[3 * v + axis];
            }
            for (int axis = 0; axis < 3; axis++) {
                double modelled = bone[axis] - inside[axis] - across * normals[3 * v + axis];
                double jump = place[axis] + outside[axis] - inside[axis];
                miss += (jump - modelled) * (jump - modelled);
                slip += modelled * modelled;
            }
            misses += Math.sqrt(miss);
            slips += Math.sqrt(slip);
            tree.closest(place[0] + outside[0], place[1] + outside[1], place[2] + outside[2], hit);
            assertThat(Math.sqrt(hit.distanceSquared))
                    .as("gap at " + Arrays.toString(place))
                    .isLessThan(1.5);
            count++;
        }
        assertThat(count).isGreaterThan(50);
        assertThat(slips / count).isGreaterThan(1);
        assertThat(misses / slips).isLessThan(0.25);
    }

    private static int ribBeside(List<TriangleTree> ribs, double[] place) {
        TriangleTree.Hit hit = new TriangleTree.Hit();
        for (int s = 0; s < ribs.size(); s++) {
            if (motion.surfaces().get(s).kind() == StructureKind.RIB
                    && ribs.get(s).closest(place[0], place[1], place[2], 5, hit)) {
                return s;
            }
        }
        return -1;
    }

    /** Distance of each voxel at rest from lungs and diaphragm, mm. */
    private static double[] toSlidingFaces() {
        List<TriangleTree> faces = motion.surfaces().stream()
                .filter(s -> s.kind() == StructureKind.LUNG || s.kind() == StructureKind.DIAPHRAGM)
                .map(s -> new TriangleTree(s.rest()))
                .toList();
        double[] out = new double[box.voxels()];
        TriangleTree.Hit hit = new TriangleTree.Hit();
        double[] p = new double[3];
        for (int v = 0; v < out.length; v++) {
            place(v, p);
            out[v] = faces.stream().anyMatch(f -> f.closest(p[0], p[1], p[2], AT_SLIDING_FACE_MM, hit)) ? 0 : 1e9;
        }
        return out;
    }

    private static void place(int v, double[] out) {
        int line = v / box.columns();
        int slice = line / box.rows();
        box.voxelToMm(v % box.columns(), line % box.rows(), slice, out);
    }

    @Test
    void nothingFoldsAwayFromSlidingFaces() {
        float[] jacobian = sampler.jacobian();
        double[] distance = toSlidingFaces();
        double least = 9;
        for (int v = 0; v < jacobian.length; v++) {
            least = distance[v] > 0 ? Math.min(least, jacobian[v]) : least;
        }
        assertThat(least).isPositive();
    }

    /** The mean of the Jacobian over the lungs is what their surfaces enclose now over what they enclosed. */
    @Test
    void theJacobianOfTheLungsIsTheirGrowth() {
        float[] ventilation = sampler.ventilation(sampler.jacobian());
        byte[] labels = sampler.labels(false);
        int lung = motion.structure("lung_L");
        TriangleMesh rest = motion.surfaces().get(lung).rest();
        double growth =
                MeshMeasure.signedVolume(rest.withPositions(motion.positions(lung))) / MeshMeasure.signedVolume(rest)
                        - 1;
        double sum = 0;
        int count = 0;
        for (int v = 0; v < labels.length; v++) {
            if (labels[v] == BodyRegions.FIRST + lung) {
                sum += ventilation[v];
                count++;
            }
        }
        assertThat(growth).isGreaterThan(0.1);
        assertThat(sum / count).isCloseTo(growth, within(0.03));
    }

    /** From each voxel forward, and back by the backward field at the place that is reached. */
    @Test
    void backwardUndoesForward() {
        float[] forward = sampler.forward();
        byte[] rest = sampler.labels(false);
        int count = 0;
        int near = 0;
        double[] p = new double[3];
        double[] w = new double[3];
        for (int v = 0; v < rest.length; v++) {
            int region = Byte.toUnsignedInt(rest[v]);
            if (region != BodyRegions.OUTSIDE) {
                place(v, p);
                double[] to = {p[0] + forward[3 * v], p[1] + forward[3 * v + 1], p[2] + forward[3 * v + 2]};
                sampler.back(region, to, w);
                double[] again = {to[0] + w[0], to[1] + w[1], to[2] + w[2]};
                count++;
                near += distance(p, again) < 0.1 ? 1 : 0;
            }
        }
        assertThat(count).isGreaterThan(50_000);
        assertThat(near).isGreaterThan((int) (0.99 * count));
    }

    /** Carried labels are those of the moved surfaces: no voxel of one region shows the label of another. */
    @Test
    void carriedLabelsAreThoseOfTheMovedSurfaces() {
        byte[] now = sampler.labels(true);
        float[] carried = sampler.warpNearest(MotionSampler.values(sampler.labels(false)));
        int wrong = 0;
        for (int v = 0; v < now.length; v++) {
            wrong += Math.round(carried[v]) == Byte.toUnsignedInt(now[v]) ? 0 : 1;
        }
        assertThat(wrong).isLessThan(now.length / 10_000);
    }

    /** What is in a moved surface comes from inside that surface at rest, or from less than half a voxel beside it. */
    @Test
    void theFieldBackEndsInTheSurfaceAtRest() {
        byte[] now = sampler.labels(true);
        for (String name : new String[] {"lung_R", "lung_L", "liver", "diaphragm"}) {
            int s = motion.structure(name);
            TriangleTree tree = new TriangleTree(motion.surfaces().get(s).rest());
            TriangleTree.Hit hit = new TriangleTree.Hit();
            double[] p = new double[3];
            double[] w = new double[3];
            double moved = 0;
            for (int v = 0; v < now.length; v += 3) {
                if (Byte.toUnsignedInt(now[v]) != BodyRegions.FIRST + s) {
                    continue;
                }
                place(v, p);
                sampler.back(BodyRegions.FIRST + s, p, w);
                double[] from = {p[0] + w[0], p[1] + w[1], p[2] + w[2]};
                moved = Math.max(moved, distance(from, p));
                // A ray along one axis tells most places; the sum over all triangles is for those beside a face.
                assertThat((tree.countAlongRay(from[0], from[1], from[2], 0, 0, 1, hit) & 1) == 1
                                || tree.isInside(from[0], from[1], from[2])
                                || tree.closest(from[0], from[1], from[2], EDGE_MM / 2, hit))
                        .as(name)
                        .isTrue();
            }
            assertThat(moved).as(name).isGreaterThan(EDGE_MM);
        }
    }

    /** Vertices of the liver that were seen 3 mm to the left of and 4 mm above where they go are 5 mm off. */
    @Test
    void pointsTellHowFarTheyAreFromWhereTheyWereSeen(@TempDir Path folder) throws IOException {
        int liver = motion.structure("liver");
        StringBuilder csv = new StringBuilder("structure,x_mm,y_mm,z_mm,to_x_mm,to_y_mm,to_z_mm\n");
        for (int v = 0; v < 60; v += 10) {
            double[] from = vertex(motion.surfaces().get(liver).rest().positions(), v);
            double[] to = vertex(motion.positions(liver), v);
            csv.append("liver");
            DoubleStream.of(from[0], from[1], from[2], to[0] + 3, to[1], to[2] + 4)
                    .forEach(c -> csv.append(',').append(c));
            csv.append('\n');
        }
        Path file = folder.resolve("points.csv");
        Files.writeString(file, csv);
        MotionPoints points = new MotionPoints(file, motion);
        DistanceSummary off = points.add(END_INSPIRATION_S).orElseThrow();
        points.write(folder.resolve("tracks.csv"));
        double[] written = CsvTable.read(folder.resolve("tracks.csv")).numbers("distance_mm");
        assertThat(off.mean()).isCloseTo(5, within(1e-9));
        assertThat(written).hasSize(6).containsOnly(new double[] {5}, within(1e-9));
    }

    @Test
    void threadsDoNotChangeTheBits() {
        try (BodyMotion other = new BodyMotion(simulation, false, LungInside.VERTICES, 3)) {
            MotionSampler twin = new MotionSampler(other, box);
            twin.update();
            assertThat(twin.backward()).isEqualTo(sampler.backward());
        }
    }

    @Test
    void namesTheStructuresThatThereAre() {
        assertThatThrownBy(() -> motion.structure("spleeen"))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("found structure 'spleeen', expected one of diaphragm, ");
    }
}
