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

    private static Thorax body(String preset) {
        return Bodies.grow(preset, Resolution.LOW);
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
                String part = level == 1 ? "sternum_manubrium" : "sternum_body";
                touch(thorax, name("costal_cartilage_%02d_%s", level, side), part);
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

    private static void touch(Thorax thorax, String one, String other) {
        Surface a = Bodies.surface(thorax, one);
        Surface b = Bodies.surface(thorax, other);
        assertThat(Math.min(a.gap(b), b.gap(a))).as(one + " to " + other).isLessThanOrEqualTo(MOST_GAP_MM);
    }

    @ParameterizedTest
    @ValueSource(strings = {"adult-male", "adult-female"})
    void organsDoNotCrossBonesOrEachOther(String preset) {
        Thorax thorax = body(preset);
        List<String> organs = List.of("diaphragm", "lung_R", "lung_L", "liver");
        for (Structure bone : thorax.structures()) {
            boolean hard = List.of(
                            StructureKind.RIB,
                            StructureKind.COSTAL_CARTILAGE,
                            StructureKind.STERNUM,
                            StructureKind.VERTEBRA)
                    .contains(bone.kind());
            for (String organ : hard ? organs : List.<String>of()) {
                Surface soft = Bodies.surface(thorax, organ);
                Surface surface = new Surface(bone.mesh());
                assertThat(surface.verticesInside(soft))
                        .as(organ + " in " + bone.name())
                        .isZero();
                assertThat(soft.verticesInside(surface))
                        .as(bone.name() + " in " + organ)
                        .isZero();
            }
        }
        Surface sheet = Bodies.surface(thorax, "diaphragm");
        for (String organ : organs.subList(1, 4)) {
            Surface soft = Bodies.surface(thorax, organ);
            assertThat(sheet.verticesInside(soft))
                    .as(organ + " in the diaphragm")
                    .isZero();
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"adult-male", "adult-female"})
    void lungsEndAboveTheLineOfInsertion(String preset) {
        Thorax thorax = body(preset);
        VirtualThoraxParameters parameters = VirtualThoraxParametersReader.preset(preset);
        ChestWall wall = new ChestWall(parameters.chestWall(), new Spine(parameters.spine()));
        DiaphragmShape dome = new DiaphragmShape(parameters.diaphragm(), wall);
        for (Structure lung : thorax.all(StructureKind.LUNG)) {
            Surface surface = new Surface(lung.mesh());
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
        Surface skin = Bodies.surface(thorax, "skin_torso");
        for (Structure structure : thorax.structures()) {
            Surface surface = new Surface(structure.mesh());
            for (int v = 0; v < structure.mesh().vertexCount() && structure.kind() != StructureKind.SKIN; v += 23) {
                double[] p = surface.vertex(v);
                assertThat(skin.contains(p)).as(structure.name()).isTrue();
                assertThat(skin.distance(p)).as(structure.name()).isGreaterThan(LEAST_SKIN_MM);
            }
        }
    }
}
