package org.phrenic.patient.label;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.phrenic.anatomy.Resolution;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.Thorax;
import org.phrenic.anatomy.virtual.VirtualThorax;
import org.phrenic.mesh.io.volume.LabelVolume;
import org.phrenic.mesh.voxel.LabelGrid;
import org.phrenic.mesh.voxel.MeshVoxelizer;
import org.phrenic.patient.segmentation.CageVoxels;

class StatedAxesTest {
    private static final int LIVER = 5;
    private static final double LUNG_VOXEL_MM = 5;
    private static final int[] LUNG_BOX = {64, 44, 52};
    private static final Map<Integer, String> NAMES = new TreeMap<>(Map.of(LIVER, "liver"));

    static {
        NAMES.putAll(CageVoxels.table(false).structures());
    }

    /** A cage whose columns run to the left, rows to the back and slices up, with a liver in front of the spine. */
    private static LabelVolume cage() {
        CageVoxels cage = new CageVoxels().withRibs(1).withVertebrae(1);
        cage.ball(30, 30, 50, 8, LIVER);
        double s = CageVoxels.SPACING_MM;
        // Turned by 5 degrees about the body's axis, as patients lie.
        double c = s * Math.cos(Math.toRadians(5));
        double d = s * Math.sin(Math.toRadians(5));
        LabelGrid grid =
                LabelGrid.of(CageVoxels.COLUMNS, CageVoxels.ROWS, CageVoxels.SLICES, cage.labels, new double[] {
                    c, -d, 0, 0, d, c, 0, 0, 0, 0, s, 0
                });
        return new LabelVolume(grid, Map.of(), List.of());
    }

    /** Whichever of the 48 axes a file states, those that its structures show are found, and put the volume right. */
    @Test
    void structuresTellTheAxesWhateverTheFileStates() {
        LabelVolume right = cage();
        LabelTable table = new LabelTable(NAMES);
        assertThat(StatedAxes.letters(right)).isEqualTo("LPS");
        assertThat(StatedAxes.contradicted(right, table, Optional.empty())).isEmpty();
        for (BodyAxes other : BodyAxes.all()) {
            LabelVolume wrong = GeometryOverride.axes(right, other.letters(right.grid()));
            Optional<StatedAxes> found = StatedAxes.contradicted(wrong, table, Optional.empty());
            if (other == BodyAxes.STATED) {
                assertThat(found).isEmpty();
                continue;
            }
            assertThat(found).as(other.letters(right.grid())).isPresent();
            assertThat(found.orElseThrow().seen()).as(found.toString()).isEqualTo("LPS");
            assertThat(found.orElseThrow().stated()).isEqualTo(other.letters(right.grid()));
            assertThat(found.orElseThrow().sidesAlone())
                    .isEqualTo(found.orElseThrow().stated().equals("RPS"));
            assertThat(GeometryOverride.axes(wrong, "LPS").grid().toMm())
                    .as("oblique as before")
                    .containsExactly(right.grid().toMm(), within(1e-9));
        }
    }

    /** Ribs and kidneys under each other's names beside a liver, spleen and stomach under their own. */
    @Test
    void exchangedNamesOfSidesAreNoAxes() {
        CageVoxels cage = new CageVoxels().withRibs(1).withVertebrae(1);
        Map<Integer, String> right = new TreeMap<>(CageVoxels.table(false).structures());
        List<String> organs = List.of("liver", "gallbladder", "stomach", "spleen", "kidney_R", "kidney_L");
        int[][] places = {{30, 30}, {38, 24}, {52, 30}, {62, 32}, {34, 42}, {56, 42}};
        for (int i = 0; i < places.length; i++) {
            cage.ball(places[i][0], places[i][1], 50, 3, i + 1);
            right.put(i + 1, organs.get(i));
        }
        LabelVolume volume = cage.volume();
        assertThat(StatedAxes.contradicted(volume, new LabelTable(right), Optional.empty()))
                .isEmpty();
        Map<Integer, String> exchanged = new TreeMap<>();
        right.forEach((label, name) -> exchanged.put(
                label,
                name.endsWith("_R")
                        ? name.replace("_R", "_L")
                        : name.endsWith("_L") ? name.replace("_L", "_R") : name));
        StatedAxes found = StatedAxes.contradicted(volume, new LabelTable(exchanged), Optional.empty())
                .orElseThrow();
        assertThat(found.sentence()).contains("names of right and left are exchanged");
        assertThat(found.expected())
                .isEqualTo("expected each label under the name of its own side, or --axes LPS to keep them");
    }

    /** Liver, right lung and left lung alone leave front and back open: only what contradicts the file counts. */
    @Test
    void whatStructuresLeaveOpenStaysAsStated() {
        CageVoxels voxels = new CageVoxels();
        voxels.ball(25, 30, 80, 12, 1);
        voxels.ball(65, 30, 80, 12, 2);
        voxels.ball(30, 30, 50, 8, LIVER);
        LabelVolume volume = voxels.volume();
        LabelTable table = new LabelTable(Map.of(1, "lung_R", 2, "lung_L", LIVER, "liver"));
        assertThat(StatedAxes.contradicted(volume, table, Optional.empty())).isEmpty();
        assertThat(StatedAxes.contradicted(GeometryOverride.axes(volume, "LAS"), table, Optional.empty()))
                .isEmpty();
        assertThat(StatedAxes.contradicted(GeometryOverride.axes(volume, "LAI"), table, Optional.empty()))
                .map(StatedAxes::seen)
                .contains("LAS");
    }

    /** Without spine and liver, a sternum in front of the oesophagus tells front from back. */
    @Test
    void aSternumBehindTheOesophagusContradictsTheFile() {
        CageVoxels voxels = new CageVoxels();
        voxels.ball(25, 30, 80, 12, 1);
        voxels.ball(65, 30, 80, 12, 2);
        voxels.ball(45, 10, 80, 3, 3);
        voxels.ball(45, 42, 80, 2, 4);
        LabelTable table = new LabelTable(Map.of(1, "lung_R", 2, "lung_L", 3, "sternum", 4, "oesophagus"));
        assertThat(StatedAxes.contradicted(voxels.volume(), table, Optional.empty()))
                .isEmpty();
        assertThat(StatedAxes.contradicted(GeometryOverride.axes(voxels.volume(), "LAS"), table, Optional.empty()))
                .map(StatedAxes::seen)
                .contains("LPS");
    }

    /** Both lungs of the virtual woman under one label. */
    private static LabelVolume lungs(Thorax body) {
        byte[] labels = new byte[LUNG_BOX[0] * LUNG_BOX[1] * LUNG_BOX[2]];
        double f = 1 / LUNG_VOXEL_MM;
        MeshVoxelizer voxels = new MeshVoxelizer(
                LUNG_BOX[0], LUNG_BOX[1], LUNG_BOX[2], new double[] {f, 0, 0, 32, 0, f, 0, 22, 0, 0, f, -4}, labels);
        body.structuresOf(StructureKind.LUNG).forEach(lung -> voxels.fill(lung.mesh(), 1));
        double s = LUNG_VOXEL_MM;
        LabelGrid grid = LabelGrid.of(LUNG_BOX[0], LUNG_BOX[1], LUNG_BOX[2], labels, new double[] {
            s, 0, 0, -32 * s, 0, s, 0, -22 * s, 0, 0, s, 4 * s
        });
        return new LabelVolume(grid, Map.of(), List.of());
    }

    /** Of lungs alone the virtual man's tell the axes of the woman's; a mirror image looks much like lungs. */
    @ParameterizedTest
    @CsvSource({
        "LPS, ",
        "RPS, ",
        "RAS, LPS",
        "LPI, LPS",
        "LAI, LPS",
        "LSP, LPS",
        "PSL, LPS",
        "RAI, LPS",
        "SRA, LPS",
    })
    void theShapeOfLungsTellsWhichWayTheyLie(String stated, String seen) {
        LungMoments usual = LungMoments.of(VirtualThorax.ofPreset("adult-male", Resolution.LOW))
                .orElseThrow();
        LabelVolume woman = lungs(VirtualThorax.ofPreset("adult-female", Resolution.LOW));
        assertThat(StatedAxes.contradicted(
                                GeometryOverride.axes(woman, stated),
                                new LabelTable(Map.of(1, LabelTable.LUNGS)),
                                Optional.of(usual))
                        .map(StatedAxes::seen))
                .isEqualTo(Optional.ofNullable(seen));
    }
}
