package org.phrenic.scene.camera;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Optional;
import java.util.function.ToDoubleFunction;
import org.joml.Vector3d;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.query.TriangleTree;
import org.phrenic.scene.SceneFixture;
import org.phrenic.scene.style.ClipPlane;
import org.phrenic.simulation.observe.Frame;
import org.phrenic.simulation.observe.Surface;

/** What lies under the cursor, on the coarse virtual adult male early in inspiration. */
class PickerTest {
    private static final int WIDTH = 640;
    private static final int HEIGHT = 480;
    /** Frames hold float coordinates of about 1000 mm. */
    private static final double FLOAT_MM = 0.01;

    private static List<Surface> surfaces;
    private static Frame frame;
    private static Picker picker;

    @BeforeAll
    static void breathe() {
        surfaces = SceneFixture.surfacesOfTheBody();
        frame = SceneFixture.begunBreath();
        picker = new Picker(surfaces);
    }

    private static ToDoubleFunction<Surface> only(StructureKind... kinds) {
        return s -> List.of(kinds).contains(s.kind()) ? 1 : 0;
    }

    /** Where the vertices of a surface are now. */
    private static double[] now(int surface) {
        Surface s = surfaces.get(surface);
        double[] now = new double[s.rest().positions().length];
        frame.writePositions(s, surface, now);
        return now;
    }

    private static Optional<PickResult> pick(double[] ray, ToDoubleFunction<Surface> opacity) {
        return picker.pick(frame, ray, Optional.empty(), opacity);
    }

    private static double[] middleOfATriangle(double[] positions, Surface surface) {
        int[] triangles = surface.rest().triangles();
        int first = triangles.length / 6 * 3;
        double[] middle = new double[3];
        for (int corner = 0; corner < 3; corner++) {
            for (int k = 0; k < 3; k++) {
                middle[k] += positions[3 * triangles[first + corner] + k] / 3;
            }
        }
        return middle;
    }

    @Test
    void everyKindOfMotionIsHitWhereItIsNow() {
        for (int i = 0; i < surfaces.size(); i++) {
            Surface s = surfaces.get(i);
            double[] now = now(i);
            double[] at = middleOfATriangle(now, s);
            Vector3d centre =
                    Camera.of(AnatomicalView.ANTERIOR, s.rest().bounds()).eye();
            double[] sight = sight(centre, at);
            double length = centre.distance(at[0], at[1], at[2]);
            Optional<PickResult> pick = pick(sight, other -> other == s ? 1 : 0);
            assertThat(pick).as(s.name()).isPresent();
            assertThat(pick.get().surface()).isSameAs(s);
            double along = (pick.get().x() - sight[0]) * sight[3]
                    + (pick.get().y() - sight[1]) * sight[4]
                    + (pick.get().z() - sight[2]) * sight[5];
            assertThat(along).as("nothing nearer is missed").isLessThan(length + 1);
            int nearest = 3 * pick.get().vertex();
            double away = Vector3d.distance(
                    now[nearest],
                    now[nearest + 1],
                    now[nearest + 2],
                    pick.get().x(),
                    pick.get().y(),
                    pick.get().z());
            assertThat(away).as("distance to the vertex named, mm").isLessThan(40);
        }
    }

    /** A ray from a point toward another. */
    private static double[] sight(Vector3d from, double[] to) {
        Vector3d along = new Vector3d(to[0], to[1], to[2]).sub(from).normalize();
        return new double[] {from.x, from.y, from.z, along.x, along.y, along.z};
    }

    /** A rib that has turned by 90 degrees and gone 40 mm to the side, farther than in any breath. */
    @Test
    void aBoneThatTurnsIsHitWhereItIsNowAndNamesItsPlaceAtRest() {
        int index = surfaces.stream().map(Surface::kind).toList().indexOf(StructureKind.RIB);
        Surface rib = surfaces.get(index);
        float[] pose = {0, -1, 0, 40, 1, 0, 0, 0, 0, 0, 1, 0};
        Frame turned = frame.copy();
        System.arraycopy(pose, 0, turned.pose(index), 0, pose.length);
        double[] middle = new double[3];
        Frame.transform(pose, middleOfATriangle(rib.rest().positions(), rib), middle);
        Vector3d front = new Vector3d(middle[0], middle[1] - 300, middle[2]);
        PickResult pick = picker.pick(turned, sight(front, middle), Optional.empty(), s -> s == rib ? 1 : 0)
                .orElseThrow();
        assertThat(pick.y()).as("nothing nearer is missed").isLessThan(middle[1] + FLOAT_MM);
        double[] now = new double[3];
        Frame.transform(pose, pick.restPosition(), now);
        assertThat(pick.position()).containsExactly(now, within(FLOAT_MM));
        TriangleTree.Hit hit = new TriangleTree.Hit();
        double[] rest = pick.restPosition();
        assertThat(new TriangleTree(rib.rest()).closest(rest[0], rest[1], rest[2], FLOAT_MM, hit))
                .as("on the bone at rest")
                .isTrue();
    }

    @Test
    void fromTheFrontTheLeftOfThePictureIsThePatientsRight() {
        double[] bounds = Surface.bounds(surfaces);
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
        Camera camera = Camera.of(AnatomicalView.ANTERIOR, Surface.bounds(surfaces), (double) WIDTH / HEIGHT);
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
        double[] box = Surface.bounds(surfaces);
        Camera front = Camera.of(AnatomicalView.ANTERIOR, box, (double) WIDTH / HEIGHT);
        double[] middle = front.ray(WIDTH / 2.0, HEIGHT / 2.0, WIDTH, HEIGHT);
        ToDoubleFunction<Surface> skin = only(StructureKind.SKIN);
        double nearest = pick(middle, skin).orElseThrow().y();
        double coronal = 0.5 * (box[1] + box[4]);
        Optional<ClipPlane> cut = Optional.of(ClipPlane.coronal(coronal));
        PickResult behind = picker.pick(frame, middle, cut, skin).orElseThrow();
        assertThat(nearest).isLessThan(coronal);
        assertThat(behind.isOnCutFace()).isTrue();
        assertThat(behind.y()).isCloseTo(coronal, within(1e-9));

        Camera back = Camera.of(AnatomicalView.POSTERIOR, box, (double) WIDTH / HEIGHT);
        double[] fromBehind = back.ray(WIDTH / 2.0, HEIGHT / 2.0, WIDTH, HEIGHT);
        assertThat(picker.pick(frame, fromBehind, cut, skin).orElseThrow().y()).isGreaterThan(coronal);
        Optional<ClipPlane> all = Optional.of(ClipPlane.coronal(box[4] + 50));
        assertThat(picker.pick(frame, fromBehind, all, s -> 1)).isEmpty();
    }

    /** A coronal plane through the middle of the liver, seen from the front, within the skin. */
    @Test
    void aClickOnACutFaceHitsTheInnermostBodyThatThePlaneCutsOpen() {
        int liver = surfaces.stream().map(Surface::kind).toList().indexOf(StructureKind.LIVER);
        Surface surface = surfaces.get(liver);
        double[] now = now(liver);
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
        double[] box = Surface.bounds(surfaces);
        double[] upwards = {0, 0.5 * (box[1] + box[4]), box[2] - 100, 0, 0, 1};
        assertThat(picker.pick(frame, upwards, Optional.of(ClipPlane.coronal(upwards[1] - 1)), s -> 1))
                .isPresent();
        assertThat(picker.pick(frame, upwards, Optional.of(ClipPlane.coronal(upwards[1] + 1)), s -> 1))
                .isEmpty();
    }

    @Test
    void aPickProjectsBackToItsPixel() {
        Camera camera = Camera.of(AnatomicalView.LEFT, Surface.bounds(surfaces), (double) WIDTH / HEIGHT);
        double[] xy = new double[2];
        PickResult pick = pick(camera.ray(300, 200, WIDTH, HEIGHT), s -> 1).orElseThrow();
        camera.project(pick.x(), pick.y(), pick.z(), WIDTH, HEIGHT, xy);
        assertThat(xy[0]).isCloseTo(300, within(FLOAT_MM));
        assertThat(xy[1]).isCloseTo(200, within(FLOAT_MM));
    }
}
