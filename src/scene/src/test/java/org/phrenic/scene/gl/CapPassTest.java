package org.phrenic.scene.gl;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.util.List;
import java.util.Optional;
import org.assertj.core.data.Percentage;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.scene.SceneFixture;
import org.phrenic.scene.camera.AnatomicalView;
import org.phrenic.scene.camera.Camera;
import org.phrenic.scene.style.ClipPlane;
import org.phrenic.scene.style.SceneStyle;
import org.phrenic.simulation.observe.Frame;
import org.phrenic.simulation.observe.Surface;

/** Cut faces are where the plane meets a body at the moment that is shown, and cost nothing where it meets none. */
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
class CapPassTest {
    private static final int WIDTH = 400;
    private static final int HEIGHT = 300;
    /** Share of white in the colour of a cut face. */
    private static final double LIGHTENING = 0.10;

    /** Depth edges darken the outline of a cut face. */
    private static final Percentage OUTLINE = Percentage.withPercentage(8);

    /** Darkening of a face that is seen at a slant, levels of 255. */
    private static final double SHADE = 8;

    private SceneFixture fixture;
    private Renderer renderer;

    @BeforeAll
    void open() {
        fixture = new SceneFixture();
        fixture.offscreen.enableDebugging();
        renderer = new Renderer(fixture.surfaces, List.of());
    }

    @AfterAll
    void close() {
        if (fixture != null) {
            fixture.offscreen.release(renderer);
            fixture.close();
        }
    }

    private BufferedImage draw(Frame frame, Camera camera, SceneStyle style) {
        return fixture.offscreen.render(renderer, frame, camera, style, WIDTH, HEIGHT);
    }

    private Surface liver() {
        return fixture.surfaces.stream()
                .filter(s -> s.kind() == StructureKind.LIVER)
                .findFirst()
                .orElseThrow();
    }

    private static SceneStyle cut(SceneStyle style, double y) {
        return style.withSamples(0).withClip(Optional.of(ClipPlane.coronal(y)));
    }

    @Test
    void aPlaneThatMeetsNoBodyCostsNoCutFaces() {
        Camera camera = fixture.camera(AnatomicalView.ANTERIOR);
        SceneStyle liver = fixture.only(fixture.style(), StructureKind.LIVER);
        double front = liver().rest().bounds()[1];
        // The background is drawn once.
        draw(fixture.rest, camera, cut(liver, front + 20));
        draw(fixture.rest, camera, cut(liver, front + 20));
        int met = renderer.statistics().drawCalls();
        draw(fixture.rest, camera, cut(liver, front - 5));
        int passed = renderer.statistics().drawCalls();
        draw(fixture.rest, camera, cut(liver, front - 1000));
        assertThat(passed)
                .as("calls that draw")
                .isEqualTo(renderer.statistics().drawCalls())
                .isEqualTo(met - 2);
    }

    /** The body has moved from its place at rest, and the picture is seen at a slant. */
    @Test
    void aCutFaceIsTheWholeSectionOfTheMoment() {
        float[] at = fixture.inspired.positions(fixture.surfaces.indexOf(liver()));
        double y = liver().rest().bounds()[1] + 60;
        SceneStyle style = fixture.only(fixture.style(), StructureKind.LIVER);
        double area = sectionArea(liver().rest().triangles(), at, y);
        for (double azimuth : new double[] {0, 35}) {
            assertShown(renderer, style, liver().name(), y, azimuth, area);
        }
    }

    /** Cut faces of a lesion and of the liver around it lie in one plane. */
    @Test
    void aBodyWithinABodyShowsItsCutFaceWithoutHoles() {
        TriangleMesh outer = liver().rest();
        double[] centre = MeshMeasure.centreOfMass(outer);
        double[] half = outer.positions().clone();
        for (int i = 0; i < half.length; i++) {
            half[i] = (half[i] + centre[i % 3]) / 2;
        }
        Surface lesion = still("lesion", StructureKind.LESION, outer.withPositions(half));
        List<Surface> nested = List.of(lesion, still("liver", StructureKind.LIVER, outer));
        Renderer two = new Renderer(nested, List.of());
        float[] at = new float[half.length];
        for (int i = 0; i < half.length; i++) {
            at[i] = (float) half[i];
        }
        double area = sectionArea(outer.triangles(), at, centre[1]);
        for (double azimuth : new double[] {0, 20, 40}) {
            assertShown(two, SceneStyle.atlas(nested), "lesion", centre[1], azimuth, area);
        }
        fixture.offscreen.release(two);
    }

    private static Surface still(String name, StructureKind kind, TriangleMesh mesh) {
        return new Surface(name, kind, 0, Side.MIDLINE, mesh, Surface.Motion.STILL, new boolean[0]);
    }

    private void assertShown(Renderer drawn, SceneStyle style, String body, double y, double azimuth, double areaMm2) {
        Camera camera =
                fixture.camera(AnatomicalView.ANTERIOR).orbit(azimuth, 0).withProjection(true);
        BufferedImage picture = fixture.offscreen.render(drawn, fixture.inspired, camera, cut(style, y), WIDTH, HEIGHT);
        float[] rgb = style.appearance(body).orElseThrow().rgb();
        int shown = 0;
        for (int pixel : picture.getRGB(0, 0, WIDTH, HEIGHT, null, 0, WIDTH)) {
            shown += isCutFace(pixel, rgb) ? 1 : 0;
        }
        double[] low = new double[2];
        double[] high = new double[2];
        camera.project(0, y, 1000, WIDTH, HEIGHT, low);
        camera.project(0, y, 1100, WIDTH, HEIGHT, high);
        double pixelsPerMm = Math.hypot(high[0] - low[0], high[1] - low[1]) / 100;
        double expected = areaMm2 * pixelsPerMm * pixelsPerMm * Math.cos(Math.toRadians(azimuth));
        assertThat((double) shown).as("pixels at %s degrees", azimuth).isCloseTo(expected, OUTLINE);
    }

    private static boolean isCutFace(int pixel, float[] rgb) {
        for (int i = 0; i < 3; i++) {
            double expected = 255 * (rgb[i] + LIGHTENING * (1 - rgb[i]));
            if (Math.abs((pixel >> 16 - 8 * i & 0xff) - expected) > SHADE) {
                return false;
            }
        }
        return true;
    }

    /** Area of the section of a closed mesh with the coronal plane at y, mm2, by Green's theorem. */
    private static double sectionArea(int[] triangles, float[] at, double y) {
        double twice = 0;
        for (int t = 0; t < triangles.length; t += 3) {
            double[] enters = null;
            double[] leaves = null;
            for (int i = 0; i < 3; i++) {
                int a = 3 * triangles[t + i];
                int b = 3 * triangles[t + (i + 1) % 3];
                if (at[a + 1] > y != at[b + 1] > y) {
                    double f = (y - at[a + 1]) / (at[b + 1] - at[a + 1]);
                    double[] x = {at[a] + f * (at[b] - at[a]), at[a + 2] + f * (at[b + 2] - at[a + 2])};
                    if (at[a + 1] > y) {
                        leaves = x;
                    } else {
                        enters = x;
                    }
                }
            }
            if (enters != null) {
                twice += enters[0] * leaves[1] - enters[1] * leaves[0];
            }
        }
        return Math.abs(twice / 2);
    }
}
