package org.phrenic.access;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.phrenic.access.ultrasound.LiverWindow;
import org.phrenic.access.ultrasound.ScannedSkin;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.file.BadInputException;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.simulation.observe.Surface;

/** Bodies of boxes whose liver lies from -90 to 90 mm in y. */
class TrunkSkinTest {
    private static Surface skin(String name, TriangleMesh mesh) {
        return new Surface(name, StructureKind.SKIN, 0, Side.MIDLINE, mesh, Surface.Motion.STILL, new boolean[0]);
    }

    @Test
    void anArmIsNoSkinForANeedleOrAProbe() {
        BoxAnatomy boxes = new BoxAnatomy();
        boxes.surfaces.add(skin("skin_arm_R", BoxAnatomy.box(-80, -30, -150, -10, 30, 150)));
        List<Surface> armFirst = new ArrayList<>(boxes.surfaces);
        armFirst.add(0, armFirst.remove(armFirst.size() - 1));
        for (List<Surface> surfaces : List.of(boxes.surfaces, armFirst)) {
            assertThat(new MovingAnatomy(surfaces).skin().surface().name()).isEqualTo("skin");
            assertThat(new ScannedSkin(surfaces).nearestPoint(new double[] {-90, 0, 0}))
                    .containsExactly(0, 0, 0);
            assertThat(LiverWindow.RIGHT_INTERCOSTAL.placeOn(surfaces)[0]).isZero();
        }
    }

    /** A scan that ends in the liver, which lies from -120 to 120 mm in z. */
    @ParameterizedTest
    @CsvSource({"120, 150", "116, 150", "150, 116"})
    void aLiverThatGoesThroughTheEndOfTheSkinIsWithin(double below, double above) {
        List<Surface> surfaces = withArm(-below, above);
        assertThat(new MovingAnatomy(surfaces).skin().surface().name()).isEqualTo("skin");
    }

    @ParameterizedTest
    @CsvSource({"114, 150", "150, 114"})
    void aSkinThatEndsWithinTheLiverIsRefused(double below, double above) {
        assertThatThrownBy(() -> TrunkSkin.of(withArm(-below, above)))
                .isInstanceOf(BadInputException.class)
                .hasMessage("the body: found 0 of the skins skin, skin_arm_R around the liver, expected one");
    }

    private static List<Surface> withArm(double fromZ, double toZ) {
        BoxAnatomy boxes = new BoxAnatomy();
        boxes.surfaces.set(0, skin("skin", BoxAnatomy.box(0, -100, fromZ, 200, 100, toZ)));
        boxes.surfaces.add(skin("skin_arm_R", BoxAnatomy.box(-80, -30, -150, -10, 30, 150)));
        return boxes.surfaces;
    }

    @Test
    void twoSkinsAboutTheLiverAreRefused() {
        BoxAnatomy boxes = new BoxAnatomy();
        boxes.surfaces.add(skin("skin_clothes", BoxAnatomy.box(-10, -110, -160, 210, 110, 160)));
        assertThatThrownBy(() -> TrunkSkin.of(boxes.surfaces))
                .isInstanceOf(BadInputException.class)
                .hasMessage("the body: found 2 of the skins skin, skin_clothes around the liver, expected one");
    }

    @Test
    void halvesOfASkinAreRefused() {
        BoxAnatomy boxes = new BoxAnatomy();
        boxes.surfaces.set(0, skin("skin_back", BoxAnatomy.box(0, 0, -150, 200, 100, 150)));
        boxes.surfaces.add(skin("skin_front", BoxAnatomy.box(0, -100, -150, 200, 0, 150)));
        assertThatThrownBy(() -> new MovingAnatomy(boxes.surfaces))
                .isInstanceOf(BadInputException.class)
                .hasMessage("the body: found 0 of the skins skin_back, skin_front around the liver, expected one");
    }
}
