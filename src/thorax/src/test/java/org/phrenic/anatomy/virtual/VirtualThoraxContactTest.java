package org.phrenic.anatomy.virtual;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Locale;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.phrenic.anatomy.Resolution;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.Thorax;

/** What joins touches, and what must not cross does not. */
class VirtualThoraxContactTest {
    private static final double MOST_GAP_MM = 0.5;
    private static final double LEAST_SKIN_MM = 4;
    private static final double LEAST_PLEURA_MM = 0.3;
    private static final List<StructureKind> HARD =
            List.of(StructureKind.RIB, StructureKind.COSTAL_CARTILAGE, StructureKind.STERNUM, StructureKind.VERTEBRA);

    private static Thorax body(String preset) {
        return VirtualThorax.ofPreset(preset, Resolution.LOW);
    }

    @ParameterizedTest
    @ValueSource(strings = {"adult-male", "adult-female"})
    void nothingFloats(String preset) {
        Thorax thorax = body(preset);
        for (String side : List.of("R", "L")) {
            for (int level = 1; level <= 12; level++) {
                touch(thorax, name("rib_%02d_%s", level, side), name("vertebra_T%02d", level));
            }
            for (int level = 1; level <= 10; level++) {
                touch(thorax, name("costal_cartilage_%02d_%s", level, side), name("rib_%02d_%s", level, side));
            }
            for (int level = 1; level <= 7; level++) {
                String[] parts =
                        level <= 2 ? new String[] {"sternum_manubrium", "sternum_body"} : new String[] {"sternum_body"};
                touch(thorax, name("costal_cartilage_%02d_%s", level, side), parts);
            }
            for (int level = 8; level <= 10; level++) {
                String above = name("costal_cartilage_%02d_%s", level - 1, side);
                touch(thorax, name("costal_cartilage_%02d_%s", level, side), above);
            }
        }
        touch(thorax, "sternum_manubrium", "sternum_body");
        touch(thorax, "sternum_body", "sternum_xiphoid");
    }

    private static String name(String pattern, Object... values) {
        return String.format(Locale.ROOT, pattern, values);
    }

    /** The first touches one of the others. */
    private static void touch(Thorax thorax, String one, String... others) {
        SurfaceChecks a = SurfaceChecks.of(thorax, one);
        double least = Double.POSITIVE_INFINITY;
        for (String other : others) {
            SurfaceChecks b = SurfaceChecks.of(thorax, other);
            least = Math.min(least, Math.min(a.gap(b), b.gap(a)));
        }
        assertThat(least).as(one + " to " + String.join(", ", others)).isLessThanOrEqualTo(MOST_GAP_MM);
    }

    @ParameterizedTest
    @ValueSource(strings = {"adult-male", "adult-female"})
    void organsDoNotCrossBonesOrEachOther(String preset) {
        Thorax thorax = body(preset);
        List<String> names = List.of("lung_R", "lung_L", "liver", "diaphragm");
        List<SurfaceChecks> organs =
                names.stream().map(name -> SurfaceChecks.of(thorax, name)).toList();
        for (Structure bone : thorax.structures()) {
            if (!HARD.contains(bone.kind())) {
                continue;
            }
            SurfaceChecks hard = new SurfaceChecks(bone.mesh());
            for (SurfaceChecks organ : organs) {
                String name = names.get(organs.indexOf(organ));
                assertThat(hard.verticesInside(organ))
                        .as(name + " in " + bone.name())
                        .isZero();
                assertThat(organ.verticesInside(hard))
                        .as(bone.name() + " in " + name)
                        .isZero();
            }
        }
        SurfaceChecks sheet = organs.get(3);
        for (SurfaceChecks organ : organs.subList(0, 3)) {
            assertThat(sheet.verticesInside(organ))
                    .as(names.get(organs.indexOf(organ)) + " in the diaphragm")
                    .isZero();
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"adult-male", "adult-female"})
    void lungsEndAboveTheLineOfInsertion(String preset) {
        Thorax thorax = body(preset);
        VirtualThoraxParameters parameters = VirtualThoraxParameters.preset(preset);
        ChestWallShape wall = new ChestWallShape(parameters.chestWall(), new Spine(parameters.spine()));
        DiaphragmShape dome = new DiaphragmShape(parameters.diaphragm(), wall);
        for (Structure lung : thorax.structuresOf(StructureKind.LUNG)) {
            SurfaceChecks surface = new SurfaceChecks(lung.mesh());
            for (int v = 0; v < lung.mesh().vertexCount(); v++) {
                double[] p = surface.vertex(v);
                assertThat(p[2]).isGreaterThan(dome.rimZ(wall.azimuth(p)) + 5);
                double least = parameters.diaphragm().muscleMm() / 2 + LEAST_PLEURA_MM;
                assertThat(dome.at(p[0], p[1], p[2])).isGreaterThan(least);
            }
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"adult-male", "adult-female"})
    void skinCoversEveryBone(String preset) {
        Thorax thorax = body(preset);
        SurfaceChecks skin = SurfaceChecks.of(thorax, "skin_torso");
        for (Structure structure : thorax.structures()) {
            SurfaceChecks surface = new SurfaceChecks(structure.mesh());
            for (int v = 0; v < structure.mesh().vertexCount() && structure.kind() != StructureKind.SKIN; v += 23) {
                double[] p = surface.vertex(v);
                assertThat(skin.contains(p)).as(structure.name()).isTrue();
                assertThat(skin.distance(p, LEAST_SKIN_MM)).as(structure.name()).isInfinite();
            }
        }
    }
}
