package org.phrenic.scene.camera;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Optional;
import java.util.function.ToDoubleFunction;
import org.joml.Vector3d;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.scenario.Scenario;
import org.phrenic.scene.ScenePlayer;
import org.phrenic.scene.style.ClipPlane;
import org.phrenic.simulation.SimulationRun;
import org.phrenic.simulation.observe.Frame;
import org.phrenic.simulation.observe.Surface;

/** What lies under the cursor, on the coarse virtual adult male in mid-inspiration. */
class PickerTest {
    private static final int WIDTH = 640;
    private static final int HEIGHT = 480;
    /** Frames hold float coordinates of about 1000 mm. */
    private static final double FLOAT_MM = 0.01;

    private static final Scenario SCENARIO =
            Scenario.defaults().with("resolution=low", "lungs=embedded", "sternum=kinematic");

    private static ScenePlayer player;
    private static Frame frame;
    private static Picker picker;

    @BeforeAll
    static void breathe() {
        player = new ScenePlayer(
                Scenario.defaults().with("resolution=low", "lungs=embedded", "sternum=kinematic"),
                (at, of, rate) -> {});
        frame = player.advanceTo(0.3);
        picker = new Picker(player.surfaces());
    }

    @AfterAll
    static void close() {
        player.close();
    }

    private static ToDoubleFunction<Surface> only(StructureKind... kinds) {
        return s -> List.of(kinds).contains(s.kind()) ? 1 : 0;
    }

    /** Where a vertex of a surface is now. */
    private static double[] place(int surface, int vertex) {
        Surface s = player.surfaces().get(surface);
        if (s.motion() == Surface.Motion.DEFORMING) {
            float[] p = frame.positions(surface);
            return new double[] {p[3 * vertex], p[3 * vertex + 1], p[3 * vertex + 2]};
        }
        double[] rest = {s.rest().x(vertex), s.rest().y(vertex), s.rest().z(vertex)};
        float[] pose = frame.pose(surface);
        if (pose.length == 0) {
            return rest;
        }
        double[] moved = new double[3];
        for (int row = 0; row < 3; row++) {
            moved[row] = pose[4 * row] * rest[0]
                    + pose[4 * row + 1] * rest[1]
                    + pose[4 * row + 2] * rest[2]
                    + pose[4 * row + 3];
        }
        return moved;
    }

    private static Optional<PickResult> pick(double[] ray, ToDoubleFunction<Surface> opacity) {
        return picker.pick(frame, ray, Optional.empty(), opacity);
    }

    private static double[] middleOfATriangle(int surface) {
        int[] triangles = player.surfaces().get(surface).rest().triangles();
        int first = triangles.length / 6 * 3;
        double[] middle = new double[3];
        for (int corner = 0; corner < 3; corner++) {
            double[] at = place(surface, triangles[first + corner]);
            for (int k = 0; k < 3; k++) {
                middle[k] += at[k] / 3;
            }
        }
        return middle;
    }

    @Test
    void everyKindOfMotionIsHitWhereItIsNow() {
        for (int i = 0; i < player.surfaces().size(); i++) {
            Surface s = player.surfaces().get(i);
            double[] at = middleOfATriangle(i);
            Vector3d centre =
                    Camera.of(AnatomicalView.ANTERIOR, s.rest().bounds()).eye();
            double[] sight = new double[6];
            double length = 0;
            for (int k = 0; k < 3; k++) {
                sight[k] = centre.get(k);
                sight[3 + k] = at[k] - centre.get(k);
                length += sight[3 + k] * sight[3 + k];
            }
            for (int k = 3; k < 6; k++) {
                sight[k] /= Math.sqrt(length);
            }
            Optional<PickResult> pick = pick(sight, other -> other == s ? 1 : 0);
            assertThat(pick).as(s.name()).isPresent();
            assertThat(pick.get().surface()).isSameAs(s);
            double along = (pick.get().x() - sight[0]) * sight[3]
                    + (pick.get().y() - sight[1]) * sight[4]
                    + (pick.get().z() - sight[2]) * sight[5];
            assertThat(along).as("nothing nearer is missed").isLessThan(Math.sqrt(length) + 1);
            double[] nearest = place(i, pick.get().vertex());
            double away = Math.hypot(
                    Math.hypot(
                            nearest[0] - pick.get().x(), nearest[1] - pick.get().y()),
                    nearest[2] - pick.get().z());
            assertThat(away).as("distance to the vertex named, mm").isLessThan(40);
        }
    }

    @Test
    void fromTheFrontTheLeftOfThePictureIsThePatientsRight() {
        double[] bounds = Surface.bounds(player.surfaces());
        Camera camera = Camera.of(AnatomicalView.ANTERIOR, bounds, (double) WIDTH / HEIGHT);
        PickResult left = sweep(camera, 0, WIDTH / 2 - 20);
        PickResult right = sweep(camera, WIDTH - 1, WIDTH / 2 + 20);
        assertThat(left.displayName()).startsWith("Rib ").endsWith(" right");
        assertThat(left.positionText()).startsWith("R ");
        assertThat(right.displayName()).startsWith("Rib ").endsWith(" left");
        assertThat(right.positionText()).startsWith("L ");
    }

    private static PickResult sweep(Camera camera, int from, int to) {
        int step = Integer.signum(to - from);
        for (int px = from; px != to; px += step) {
            Optional<PickResult> pick = pick(camera.ray(px, HEIGHT / 2.0, WIDTH, HEIGHT), only(StructureKind.RIB));
            if (pick.isPresent()) {
                return pick.get();
            }
        }
        throw new AssertionError("no rib between " + from + " and " + to);
    }

    @Test
    void whatIsNearlyTransparentIsLookedThroughUnlessThereIsNothingBehind() {
        Camera camera = Camera.of(AnatomicalView.ANTERIOR, Surface.bounds(player.surfaces()), (double) WIDTH / HEIGHT);
        double[] middle = camera.ray(WIDTH / 2.0, HEIGHT / 2.0, WIDTH, HEIGHT);
        ToDoubleFunction<Surface> glassSkin = s -> s.kind() == StructureKind.SKIN ? 0.3 : 1;
        assertThat(pick(middle, glassSkin).orElseThrow().surface().kind()).isNotEqualTo(StructureKind.SKIN);
        assertThat(pick(middle, s -> 1).orElseThrow().surface().kind()).isEqualTo(StructureKind.SKIN);
        assertThat(pick(middle, s -> s.kind() == StructureKind.SKIN ? 0.3 : 0)
                        .orElseThrow()
                        .displayName())
                .isEqualTo("Skin");
        assertThat(pick(middle, s -> 0)).isEmpty();
        assertThat(pick(camera.ray(1, 1, WIDTH, HEIGHT), s -> 1)).isEmpty();
    }

    @Test
    void whatThePlaneCutsAwayIsNotPicked() {
        double[] box = Surface.bounds(player.surfaces());
        Camera front = Camera.of(AnatomicalView.ANTERIOR, box, (double) WIDTH / HEIGHT);
        double[] middle = front.ray(WIDTH / 2.0, HEIGHT / 2.0, WIDTH, HEIGHT);
        ToDoubleFunction<Surface> skin = only(StructureKind.SKIN);
        double nearest = pick(middle, skin).orElseThrow().y();
        double coronal = 0.5 * (box[1] + box[4]);
        Optional<ClipPlane> cut = Optional.of(ClipPlane.coronal(coronal));
        PickResult behind = picker.pick(frame, middle, cut, skin).orElseThrow();
        assertThat(nearest).isLessThan(coronal);
        assertThat(behind.y()).isGreaterThan(coronal);

        Camera back = Camera.of(AnatomicalView.POSTERIOR, box, (double) WIDTH / HEIGHT);
        double[] fromBehind = back.ray(WIDTH / 2.0, HEIGHT / 2.0, WIDTH, HEIGHT);
        assertThat(picker.pick(frame, fromBehind, cut, skin).orElseThrow().y()).isGreaterThan(coronal);
        Optional<ClipPlane> all = Optional.of(ClipPlane.coronal(box[4] + 50));
        assertThat(picker.pick(frame, fromBehind, all, s -> 1)).isEmpty();
    }

    /** A coronal plane through the middle of the liver, seen from the front, within the skin. */
    @Test
    void aClickOnACutFaceHitsTheInnermostBodyThatThePlaneCutsOpen() {
        int liver = player.surfaces().stream().map(Surface::kind).toList().indexOf(StructureKind.LIVER);
        Surface surface = player.surfaces().get(liver);
        double[] now = new double[surface.rest().positions().length];
        frame.writePositions(surface, liver, now);
        double[] moved = new double[3];
        for (int i = 0; i < now.length; i++) {
            moved[i % 3] += 3 * (now[i] - surface.rest().positions()[i]) / now.length;
        }
        assertThat(moved[2]).as("the liver has gone down, mm").isLessThan(-0.5);
        double[] centre = MeshMeasure.centreOfMass(surface.rest().withPositions(now));
        double[] ray = {centre[0], centre[1] - 500, centre[2], 0, 1, 0};
        Optional<ClipPlane> cut = Optional.of(ClipPlane.coronal(centre[1]));
        PickResult pick = picker.pick(frame, ray, cut, only(StructureKind.LIVER, StructureKind.SKIN))
                .orElseThrow();
        assertThat(pick.surface()).isSameAs(surface);
        assertThat(pick.isOnCutFace()).isTrue();
        assertThat(pick.position()).containsExactly(centre, within(1e-9));
        for (int axis = 0; axis < 3; axis++) {
            assertThat(pick.restPosition()[axis]).isCloseTo(centre[axis] - moved[axis], within(0.15));
        }
        PickResult skin = picker.pick(frame, ray, cut, only(StructureKind.SKIN)).orElseThrow();
        assertThat(skin.isOnCutFace()).isTrue();

        PickResult translucent =
                picker.pick(frame, ray, cut, s -> s == surface ? 0.8 : 0).orElseThrow();
        assertThat(translucent.isOnCutFace()).isFalse();
        assertThat(translucent.y()).as("its wall behind the plane").isGreaterThan(centre[1] + 10);
        PickResult whole = pick(ray, only(StructureKind.LIVER)).orElseThrow();
        assertThat(whole.isOnCutFace()).isFalse();
        assertThat(whole.y()).isLessThan(centre[1] - 10);
    }

    @Test
    void aRayAlongThePlaneHitsWhatIsBehindItAlone() {
        double[] box = Surface.bounds(player.surfaces());
        double[] upwards = {0, 0.5 * (box[1] + box[4]), box[2] - 100, 0, 0, 1};
        assertThat(picker.pick(frame, upwards, Optional.of(ClipPlane.coronal(upwards[1] - 1)), s -> 1))
                .isPresent();
        assertThat(picker.pick(frame, upwards, Optional.of(ClipPlane.coronal(upwards[1] + 1)), s -> 1))
                .isEmpty();
    }

    @Test
    void aPickProjectsBackToItsPixel() {
        Camera camera = Camera.of(AnatomicalView.LEFT, Surface.bounds(player.surfaces()), (double) WIDTH / HEIGHT);
        double[] xy = new double[2];
        PickResult pick = pick(camera.ray(300, 200, WIDTH, HEIGHT), s -> 1).orElseThrow();
        camera.project(pick.x(), pick.y(), pick.z(), WIDTH, HEIGHT, xy);
        assertThat(xy[0]).isCloseTo(300, within(FLOAT_MM));
        assertThat(xy[1]).isCloseTo(200, within(FLOAT_MM));
    }

    @Test
    void thePlayerIsWhereARunOfThatLengthEnds() {
        String run = SimulationRun.run(SCENARIO.with("duration_s=0.3"), null, (at, of, rate) -> {})
                .get("state_sha256")
                .toString();
        assertThat(player.stateHash()).isEqualTo(run);
    }

    @Test
    void timeDoesNotGoBack() {
        assertThatThrownBy(() -> player.advanceTo(0.1)).hasMessageContaining("expected times in order");
    }
}
