package org.phrenic.access;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.phrenic.access.plan.RehearsalPlan;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.file.BadInputException;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.edit.MeshMerge;
import org.phrenic.simulation.observe.Surface;

/** Lesions in the {@link BoxAnatomy}, whose liver is from x = 40 to 140 mm. */
class ScannedLesionTest {
    private static final double TOLERANCE_MM = 1e-9;
    /** Diameter of the sphere with the volume of a cube of 1 mm. */
    private static final double CUBE = Math.cbrt(6 / Math.PI);

    private final BoxAnatomy boxes = new BoxAnatomy();
    private MovingAnatomy body;

    @TempDir
    private Path folder;

    private static TriangleMesh cube(double x, double y, double z, double edge) {
        double h = edge / 2;
        return BoxAnatomy.box(x - h, y - h, z - h, x + h, y + h, z + h);
    }

    private void add(String name, TriangleMesh mesh) {
        boxes.surfaces.add(
                new Surface(name, StructureKind.LESION, 0, Side.MIDLINE, mesh, Surface.Motion.STILL, new boolean[0]));
    }

    @BeforeEach
    void addLesions() {
        add("liver_tumor", MeshMerge.merge(List.of(cube(70, 10, 20, 8), cube(100, -30, 5, 20))));
        add("lesion_nodule", cube(25, 0, 50, 12));
        add("lesion_small", cube(120, 0, 0, 2));
        body = new MovingAnatomy(boxes.surfaces);
    }

    @Test
    void eachPieceInTheLiverIsATargetOfItsVolumeAboutItsMiddle() {
        List<ScannedLesion> lesions = ScannedLesion.of(body);
        assertThat(lesions)
                .extracting(ScannedLesion::name)
                .as("the nodule lies in the lung")
                .containsExactly("liver_tumor", "liver_tumor#2", "lesion_small");
        assertThat(lesions).extracting(ScannedLesion::label).containsExactly("liver tumor", "liver tumor 2", "small");
        TargetLesion largest = lesions.get(0).target();
        assertThat(largest.diameterMm()).isCloseTo(20 * CUBE, within(TOLERANCE_MM));
        assertThat(largest.restMm()).containsExactly(new double[] {100, -30, 5}, within(TOLERANCE_MM));
        assertThat(lesions.get(1).target().restMm()).containsExactly(new double[] {70, 10, 20}, within(TOLERANCE_MM));
        assertThat(lesions.get(2).target().diameterMm()).as("at least").isEqualTo(TargetLesion.SMALLEST_MM);
    }

    private RehearsalPlan plan(String target) throws IOException {
        return RehearsalPlan.read(
                Files.writeString(folder.resolve("plan.yaml"), "target: {" + target + "}\nsteps: []\n"));
    }

    @Test
    void aPlanNamesALesion() throws IOException {
        RehearsalPlan plan = plan("lesion: liver_tumor#2");
        TargetLesion target = plan.target(body);
        assertThat(target.restMm()).containsExactly(new double[] {70, 10, 20}, within(TOLERANCE_MM));
        assertThat(target.diameterMm()).isCloseTo(8 * CUBE, within(TOLERANCE_MM));
        assertThat(plan.toMap("scenario.yaml").get("target").toString()).contains("lesion", "liver_tumor#2");
        assertThat(plan("lesion: liver_tumor, diameter_mm: 30").target(body).diameterMm())
                .isEqualTo(30);
        assertThatThrownBy(() -> plan("lesion: lesion_nodule").target(body))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("no lesion 'lesion_nodule' in the liver, expected one of liver_tumor,");
        assertThatThrownBy(() -> plan("lesion: liver_tumor, seed: 3"))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("found 2 of rest_mm, seed and lesion");
    }
}
