package org.phrenic.patient;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.phrenic.file.BadInputException;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.MeshTopology;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.io.volume.LabelVolume;
import org.phrenic.mesh.io.volume.LabelVolumeFiles;
import org.phrenic.mesh.voxel.LabelGrid;
import org.phrenic.patient.label.GeometryOverride;
import org.phrenic.patient.label.LabelGuess;
import org.phrenic.patient.label.LabelTable;

class ScanImportTest {
    private static final LabelTable MAP =
            new LabelTable(Map.of(ScanSamples.LUNGS, LabelTable.LUNGS, ScanSamples.LIVER, "liver"));

    private static final LabelTable SKIN = new LabelTable(Map.of(7, "skin_torso"));

    private static PatientBody body(LabelVolume volume, LabelTable map) {
        return new ScanImport(volume, "scan", MeshingSettings.PAPER, Optional.empty(), (n, of, what) -> {})
                .run(map, "body");
    }

    @Test
    void lungsThatTouchAreToldApartAndEachStructureSaysWhereItCameFrom() {
        PatientBody body = body(ScanSamples.volume(), MAP);
        assertThat(body.structures())
                .extracting(o -> o.structure().name())
                .containsExactly("liver", "lung_L", "lung_R");
        for (PatientStructure organ : body.structures()) {
            assertThat(organ.source()).isEqualTo(PatientStructure.Source.SCAN);
            PatientStructure.Scan scan = organ.scan().orElseThrow();
            TriangleMesh mesh = organ.structure().mesh();
            MeshTopology topology = new MeshTopology(mesh);
            assertThat(topology.isClosed() && topology.isManifold()).isTrue();
            assertThat(MeshMeasure.signedVolume(mesh) / 1000)
                    .isCloseTo(scan.volumeMl(), within(0.03 * scan.volumeMl()));
            assertThat(scan.meshed().distanceToLabel().mean()).isLessThan(0.5 * ScanSamples.SPACING_MM);
            assertThat(scan.meshed().quality().smallestAngleDeg()).isGreaterThan(15);
            assertThat(scan.isComplete()).isTrue();
        }
        double[] right =
                body.structure("lung_R").orElseThrow().structure().mesh().bounds();
        double[] left =
                body.structure("lung_L").orElseThrow().structure().mesh().bounds();
        // In LPS the patient's right has the smaller x; the label has both lungs touch at column 30, x = 0.
        assertThat(right[0]).isLessThan(left[0]);
        assertThat(right[3]).isCloseTo(0, within(3 * ScanSamples.SPACING_MM));
        assertThat(left[0]).isCloseTo(0, within(3 * ScanSamples.SPACING_MM));
        assertThat(body.missing()).contains("diaphragm", "rib_01_R").doesNotContain("liver", "lung_R");
        assertThat(body.canBreathe()).isFalse();
    }

    @Test
    void theSkinIsTheOutlineOfAllThatIsInIt() {
        PatientBody bare = body(ScanSamples.volume(label -> label == ScanSamples.LIVER ? 7 : 0, Map.of()), SKIN);
        PatientBody full = body(
                ScanSamples.volume(label -> label == ScanSamples.LIVER ? 7 : label, Map.of()),
                new LabelTable(Map.of(7, "skin_torso", ScanSamples.LUNGS, LabelTable.LUNGS)));
        TriangleMesh skin =
                full.structure("skin_torso").orElseThrow().structure().mesh();
        assertThat(new MeshTopology(skin).isClosed()).isTrue();
        // Lungs that lie beside it, and touch it, are within the outline.
        assertThat(MeshMeasure.signedVolume(skin))
                .isGreaterThan(2
                        * MeshMeasure.signedVolume(
                                bare.structures().get(0).structure().mesh()));
        assertThat(full.structures()).hasSize(3);
    }

    @Test
    void theSameVolumeGivesTheSameBits() {
        assertThat(body(ScanSamples.volume(), MAP)
                        .structures()
                        .get(1)
                        .structure()
                        .mesh()
                        .positions())
                .isEqualTo(body(ScanSamples.volume(), MAP)
                        .structures()
                        .get(1)
                        .structure()
                        .mesh()
                        .positions());
    }

    @Test
    void severalLabelsMakeOneStructureAndOthersAreLeftAlone() {
        LabelVolume lobes = ScanSamples.volume(label -> label == 0 ? 0 : label + 6, Map.of(7, "x", 11, "y"));
        PatientBody body = body(lobes, new LabelTable(Map.of(7, "liver", 11, "liver")));
        assertThat(body.structures())
                .singleElement()
                .satisfies(o -> assertThat(o.scan().orElseThrow().labels()).isEqualTo(List.of(7, 11)));
    }

    @Test
    void whatTheScanCutsOffIsSaid() {
        LabelVolume whole = ScanSamples.volume();
        LabelGrid grid = whole.grid();
        int from = 20;
        byte[] slab = new byte[ScanSamples.COLUMNS * ScanSamples.ROWS * 20];
        System.arraycopy(ScanSamples.voxels(), from * ScanSamples.COLUMNS * ScanSamples.ROWS, slab, 0, slab.length);
        double s = ScanSamples.SPACING_MM;
        LabelVolume cut = new LabelVolume(
                LabelGrid.of(grid.columns(), grid.rows(), 20, slab, new double[] {s, 0, 0, 0, 0, s, 0, 0, 0, 0, s, 0}),
                Map.of(),
                List.of());
        PatientBody body = body(cut, new LabelTable(Map.of(1, LabelTable.LUNGS)));
        assertThat(body.structure("lung_R").orElseThrow().scan().orElseThrow().cutAt())
                .isEqualTo("IS");
        assertThat(body.notes())
                .anyMatch(note -> note.contains("cut off by the end of the scan") && note.contains("lung_R (IS)"));
    }

    @Test
    void statedAxesTurnTheVolumeAboutItsMiddleAndALargerLeftLungIsRemarkedOn() {
        LabelVolume turned = GeometryOverride.axes(ScanSamples.volume(), "RAS");
        PatientBody body = body(turned, MAP);
        double right =
                body.structure("lung_R").orElseThrow().scan().orElseThrow().volumeMl();
        assertThat(right)
                .isLessThan(body.structure("lung_L")
                        .orElseThrow()
                        .scan()
                        .orElseThrow()
                        .volumeMl());
        assertThat(body.notes()).anyMatch(note -> note.contains("--axes"));
        double[] before = new double[3];
        double[] after = new double[3];
        ScanSamples.volume().grid().voxelToMm(29.5, 19.5, 24.5, before);
        turned.grid().voxelToMm(29.5, 19.5, 24.5, after);
        assertThat(after).containsExactly(before, within(1e-9));
        for (String bad : List.of("LLS", "LP", "XYZ")) {
            assertThatThrownBy(() -> GeometryOverride.axes(ScanSamples.volume(), bad))
                    .isInstanceOf(BadInputException.class)
                    .hasMessageContaining("three letters");
        }
    }

    /** The liver's cavity holds a cyst with a label of its own: no piece of either is left out, and no note says so. */
    @Test
    void aCavityIsNoPieceThatIsLeftOut() {
        byte[] labels = ScanSamples.voxels();
        for (int v = 0; v < labels.length; v++) {
            int i = v % ScanSamples.COLUMNS;
            int j = v / ScanSamples.COLUMNS % ScanSamples.ROWS;
            int k = v / ScanSamples.COLUMNS / ScanSamples.ROWS;
            if (Math.abs(i - 20) < 5 && Math.abs(j - 18) < 5 && Math.abs(k - 9) < 4) {
                labels[v] = 7;
            }
        }
        double s = ScanSamples.SPACING_MM;
        LabelGrid grid = LabelGrid.of(ScanSamples.COLUMNS, ScanSamples.ROWS, ScanSamples.SLICES, labels, new double[] {
            s, 0, 0, 0, 0, s, 0, 0, 0, 0, s, 0
        });
        PatientBody body = body(
                new LabelVolume(grid, Map.of(), List.of()),
                new LabelTable(Map.of(ScanSamples.LIVER, "kidney_R", 7, "kidney_cyst_R")));
        assertThat(body.notes()).noneMatch(note -> note.contains("left out"));
    }

    /** Three vertebrae that do not touch, under the label of all: each is an obstacle, and tells where the spine is. */
    @Test
    void allBonesUnderOneLabelAreKept() {
        byte[] labels = new byte[ScanSamples.COLUMNS * ScanSamples.ROWS * ScanSamples.SLICES];
        for (int v = 0; v < labels.length; v++) {
            int i = v % ScanSamples.COLUMNS;
            int j = v / ScanSamples.COLUMNS % ScanSamples.ROWS;
            int k = v / ScanSamples.COLUMNS / ScanSamples.ROWS;
            boolean bone = Math.abs(i - 30) < 5 && Math.abs(j - 30) < 4 && k >= 5 && k < 35 && k % 10 < 7;
            labels[v] = (byte) (bone ? 3 : 0);
        }
        double s = ScanSamples.SPACING_MM;
        LabelGrid grid = LabelGrid.of(ScanSamples.COLUMNS, ScanSamples.ROWS, ScanSamples.SLICES, labels, new double[] {
            s, 0, 0, 0, 0, s, 0, 0, 0, 0, s, 0
        });
        for (String several : List.of(LabelTable.SPINE, LabelTable.ALL_BONES)) {
            PatientBody body = body(new LabelVolume(grid, Map.of(), List.of()), new LabelTable(Map.of(3, several)));
            PatientStructure bones = body.structure(several).orElseThrow();
            double scanMl = bones.scan().orElseThrow().volumeMl();
            assertThat(MeshMeasure.signedVolumeMl(bones.structure().mesh())).isCloseTo(scanMl, within(0.1 * scanMl));
            assertThat(body.notes()).noneMatch(note -> note.contains("the largest was taken"));
        }
    }

    @Test
    void whatCannotBeBuiltIsToldInOneSentence() {
        assertThatThrownBy(() -> body(ScanSamples.volume(), new LabelTable(Map.of(3, "liver"))))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("none of the 1 labels");
        assertThatThrownBy(
                        () -> body(ScanSamples.volume(), new LabelTable(Map.of(ScanSamples.LIVER, LabelTable.LUNGS))))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("does not part into two");
        assertThatThrownBy(() -> LabelGuess.of(ScanSamples.volume()).require("scan"))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("--labels");
    }

    /** macOS and Windows take Liver.vtp and liver.vtp for one file. */
    @Test
    void structuresThatDifferByCaseAloneAreRefused(@TempDir Path folder) throws IOException {
        Path table = Files.writeString(folder.resolve("labels.csv"), "label,structure\n1,liver\n2,lungs\n3,Liver\n");
        assertThatThrownBy(() -> LabelTable.of(table.toString(), ScanSamples.volume()))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("labels.csv: line 4")
                .hasMessageContaining("found 'Liver' besides 'liver', expected one spelling");
    }

    @Test
    void namesOfTotalSegmentatorAreKnownByNameAndByNumber() {
        LabelVolume named = ScanSamples.volume(l -> l, Map.of(1, "lung_lower_lobe_right", 5, "liver", 9, "brain"));
        assertThat(LabelGuess.of(named).require("scan").structures()).isEqualTo(Map.of(1, "lung_R", 5, "liver"));
        assertThat(LabelTable.of(LabelTable.TOTALSEGMENTATOR, named).structures())
                .isEqualTo(Map.of(1, "lung_R", 5, "liver", 9, "brain"));
        assertThat(LabelTable.of(LabelTable.TOTALSEGMENTATOR, ScanSamples.volume())
                        .structures())
                .hasSize(117)
                .containsEntry(5, "liver")
                .containsEntry(92, "rib_01_L")
                .containsEntry(115, "rib_12_R");
    }

    @Test
    void aRealSlabHasItsLiverOnTheRightAndCartilagesByRib() {
        Path file = Path.of("../shared/segmentations/example_seg.nii.gz");
        assumeTrue(Files.exists(file), "no ../shared/segmentations here: the real slab is not imported");
        LabelVolume volume = LabelVolumeFiles.read(file);
        assertThat(LabelGuess.of(volume).require("scan").structures()).containsEntry(111, "rib_08_R");
        PatientBody body = body(
                volume,
                new LabelTable(Map.of(
                        5,
                        "liver",
                        11,
                        "lung_L",
                        111,
                        "rib_08_R",
                        115,
                        "rib_12_R",
                        117,
                        LabelTable.COSTAL_CARTILAGES)));
        double[] liver =
                body.structure("liver").orElseThrow().structure().mesh().bounds();
        double[] leftLung =
                body.structure("lung_L").orElseThrow().structure().mesh().bounds();
        assertThat(liver[0] + liver[3]).isLessThan(leftLung[0] + leftLung[3]);
        assertThat(body.structure("costal_cartilage_08_R")).isPresent();
        assertThat(body.structure("rib_12_R")
                        .orElseThrow()
                        .scan()
                        .orElseThrow()
                        .meshed()
                        .distanceToLabel()
                        .mean())
                .isLessThan(1.5);
    }
}
