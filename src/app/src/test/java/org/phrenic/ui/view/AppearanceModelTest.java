package org.phrenic.ui.view;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.scene.style.Appearance;
import org.phrenic.simulation.observe.Surface;

/** What can be shown and hidden. */
class AppearanceModelTest {
    private static Surface surface(StructureKind kind) {
        TriangleMesh mesh = new TriangleMesh(new double[] {0, 0, 0, 1, 0, 0, 0, 1, 0}, new int[] {0, 1, 2});
        return new Surface("it", kind, 0, Side.MIDLINE, mesh, Surface.Motion.STILL, new boolean[0]);
    }

    @ParameterizedTest
    @EnumSource(StructureKind.class)
    void everyKindOfStructureCanBeHidden(StructureKind kind) {
        AppearanceModel model = new AppearanceModel();
        model.setSurfaces(List.of(surface(kind)));
        assertThat(model.groups()).hasSize(1);
        model.changeGroup(model.groups().get(0), look -> look.withVisible(false));
        assertThat(model.style().appearance("it").map(Appearance::visible)).contains(false);
    }

    @Test
    void everyGroupHasALabelOfItsOwn() {
        assertThat(Arrays.stream(AppearanceModel.Group.values()).map(AppearanceModel.Group::label))
                .doesNotHaveDuplicates();
    }
}
