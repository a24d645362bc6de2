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
import org.phrenic.ui.view.AppearanceModel.Group;
import org.phrenic.ui.view.AppearanceModel.Property;

/** What can be shown and hidden. */
class AppearanceModelTest {
    private static Surface surface(StructureKind kind) {
        TriangleMesh mesh = new TriangleMesh(new double[] {0, 0, 0, 1, 0, 0, 0, 1, 0}, new int[] {0, 1, 2});
        return new Surface(kind.name(), kind, 0, Side.MIDLINE, mesh, Surface.Motion.STILL, new boolean[0]);
    }

    @ParameterizedTest
    @EnumSource(StructureKind.class)
    void everyKindOfStructureCanBeHidden(StructureKind kind) {
        AppearanceModel model = new AppearanceModel();
        model.setSurfaces(List.of(surface(kind)));
        assertThat(model.groups()).hasSize(1);
        model.changeGroup(model.groups().get(0), Property.VISIBILITY, look -> look.withVisible(false));
        assertThat(model.style().appearance(kind.name()).map(Appearance::visible))
                .contains(false);
    }

    @Test
    void whatWasChosenAppliesToTheNextBodyHoweverOftenItWasChanged() {
        AppearanceModel model = new AppearanceModel();
        model.setSurfaces(List.of(surface(StructureKind.LIVER)));
        for (int change = 0; change <= 100_000; change++) {
            float share = change % 2 == 0 ? 0.25f : 0.75f;
            model.changeGroup(Group.LIVER, Property.OPACITY, look -> look.withOpacity(share));
        }
        model.changeGroup(Group.LIVER, Property.WIREFRAME, look -> look.withWireframe(true));
        model.setSurfaces(List.of(surface(StructureKind.LIVER), surface(StructureKind.SKIN)));
        Appearance liver = model.appearance(Group.LIVER).orElseThrow();
        assertThat(liver.opacity()).isEqualTo(0.25f);
        assertThat(liver.wireframe()).isTrue();
        assertThat(model.appearance(Group.SKIN).orElseThrow().wireframe()).isFalse();
    }

    @Test
    void everyGroupHasALabelOfItsOwn() {
        assertThat(Arrays.stream(Group.values()).map(Group::label)).doesNotHaveDuplicates();
    }
}
