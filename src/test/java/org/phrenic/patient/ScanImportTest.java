package org.phrenic.patient;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.phrenic.format.BadInputException;
import org.phrenic.format.LabelVolume;
import org.phrenic.format.LabelVolumes;
import org.phrenic.geometry.LabelGrid;
import org.phrenic.geometry.MeshMeasure;
import org.phrenic.geometry.MeshTopology;
import org.phrenic.geometry.TriangleMesh;

class ScanImportTest {
    private static final LabelMap MAP =
            new LabelMap(Map.of(ScanSamples.LUNGS, LabelMap.LUNGS, ScanSamples.LIVER, "liver"));

    private static final LabelMap SKIN = new LabelMap(Map.of(7, "skin_torso"));

    private static FittedBody body(LabelVolume volume, LabelMap map) {
        return new ScanImport(volume, "scan", MeshingSteps.PAPER, Optional.empty(), (n, of, what) -> {})
                .run(map, "body");
    }

    @Test
    void lungsThatTouchAreToldApartAndEachStructureSaysWhereItCameFrom() {
        FittedBody body = body(ScanSamples.volume(), MAP);
        assertThat(body.organs()).extracting(o -> o.structure().name()).containsExactly("liver", "lung_L", "lung_R");
        for (Organ organ : body.organs()) {
            assertThat(organ.source()).isEqualTo(Organ.Source.SCAN);
            Organ.Scan scan = organ.scan().orElseThrow();
            TriangleMesh mesh = organ.structure().mesh();
            MeshTopology topology = new MeshTopology(mesh);
            assertThat(topology.isClosed() && topology.isManifold()).isTrue();
            assertThat(MeshMeasure.signedVolume(mesh) / 1000)
                    .isCloseTo(scan.volumeMl(), within(0.03 * scan.volumeMl()));
            assertThat(scan.meshed().offLabel().mean()).isLessThan(0.5 * ScanSamples.SPACING_MM);
            assertThat(scan.meshed().quality().smallestAngleDeg()).isGreaterThan(15);
            assertThat(scan.isWhole()).isTrue();
        }
        double[] right = body.find("lung_R").orElseThrow().structure().mesh().bounds();
        double[] left = body.find("lung_L").orElseThrow().structure().mesh().bounds();
        // In LPS the patient's right has the smaller x; the label has both lungs touch at column 30, x = 0.
        assertThat(right[0]).isLessThan(left[0]);
        assertThat(right[3]).isCloseTo(0, within(3 * ScanSamples.SPACING_MM));
        assertThat(left[0]).isCloseTo(0, within(3 * ScanSamples.SPACING_MM));
        assertThat(body.missing()).contains("diaphragm", "rib_01_R").doesNotContain("liver", "lung_R");
        assertThat(body.canBreathe()).isFalse();
    }

    @Test
    void theSkinIsTheOutlineOfAllThatIsInIt() {
        FittedBody bare = body(ScanSamples.volume(label -> label == ScanSamples.LIVER ? 7 : 0, Map.of()), SKIN);
        FittedBody full = body(
                ScanSamples.volume(label -> label == ScanSamples.LIVER ? 7 : label, Map.of()),
                new LabelMap(Map.of(7, "skin_torso", ScanSamples.LUNGS, LabelMap.LUNGS)));
        TriangleMesh skin = full.find("skin_torso").orElseThrow().structure().mesh();
        assertThat(new MeshTopology(skin).isClosed()).isTrue();
        // Lungs that lie beside it, and touch it, are within the outline.
        assertThat(MeshMeasure.signedVolume(skin))
                .isGreaterThan(2
                        * MeshMeasure.signedVolume(
                                bare.organs().get(0).structure().mesh()));
        assertThat(full.organs()).hasSize(3);
    }

    @Test
    void theSameVolumeGivesTheSameBits() {
        assertThat(body(ScanSamples.volume(), MAP)
                        .organs()
                        .get(1)
                        .structure()
                        .mesh()
                        .positions())
                .isEqualTo(body(ScanSamples.volume(), MAP)
                        .organs()
                        .get(1)
                        .structure()
                        .mesh()
                        .positions());
    }

    @Test
    void severalLabelsMakeOneStructureAndOthersAreLeftAlone() {
        LabelVolume lobes = ScanSamples.volume(label -> label == 0 ? 0 : label + 6, Map.of(7, "x", 11, "y"));
        FittedBody body = body(lobes, new LabelMap(Map.of(7, "liver", 11, "liver")));
        assertThat(body.organs())
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
        FittedBody body = body(cut, new LabelMap(Map.of(1, LabelMap.LUNGS)));
        assertThat(body.find("lung_R").orElseThrow().scan().orElseThrow().cutAt())
                .isEqualTo("IS");
        assertThat(body.notes())
                .anyMatch(note -> note.contains("cut off by the end of the scan") && note.contains("lung_R (IS)"));
    }

    @Test
    void statedAxesTurnTheVolumeAboutItsMiddleAndALargerLeftLungIsRemarkedOn() {
        LabelVolume turned = StatedAxes.apply(ScanSamples.volume(), "RAS");
        FittedBody body = body(turned, MAP);
        double right = body.find("lung_R").orElseThrow().scan().orElseThrow().volumeMl();
        assertThat(right)
                .isLessThan(
                        body.find("lung_L").orElseThrow().scan().orElseThrow().volumeMl());
        assertThat(body.notes()).anyMatch(note -> note.contains("--axes"));
        double[] before = new double[3];
        double[] after = new double[3];
        ScanSamples.volume().grid().place(29.5, 19.5, 24.5, before);
        turned.grid().place(29.5, 19.5, 24.5, after);
        assertThat(after).containsExactly(before, within(1e-9));
        for (String bad : List.of("LLS", "LP", "XYZ")) {
            assertThatThrownBy(() -> StatedAxes.apply(ScanSamples.volume(), bad))
                    .isInstanceOf(BadInputException.class)
                    .hasMessageContaining("three letters");
        }
    }

    @Test
    void whatCannotBeBuiltIsToldInOneSentence() {
        assertThatThrownBy(() -> body(ScanSamples.volume(), new LabelMap(Map.of(3, "liver"))))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("none of the 1 labels");
        assertThatThrownBy(() -> body(ScanSamples.volume(), new LabelMap(Map.of(ScanSamples.LIVER, LabelMap.LUNGS))))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("does not part into two");
        assertThatThrownBy(() -> LabelMap.named("scan", ScanSamples.volume()))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("--labels");
    }

    @Test
    void namesOfTotalSegmentatorAreKnownByNameAndByNumber() {
        LabelVolume named = ScanSamples.volume(l -> l, Map.of(1, "lung_lower_lobe_right", 5, "liver", 9, "brain"));
        assertThat(LabelMap.named("scan", named).structures()).isEqualTo(Map.of(1, "lung_R", 5, "liver"));
        assertThat(LabelMap.totalSegmentator(named).structures()).isEqualTo(Map.of(1, "lung_R", 5, "liver"));
        assertThat(LabelMap.totalSegmentator(ScanSamples.volume()).structures())
                .hasSize(50)
                .containsEntry(5, "liver")
                .containsEntry(92, "rib_01_L")
                .containsEntry(115, "rib_12_R");
    }

    @Test
    void aRealSlabHasItsLiverOnTheRightAndCartilagesByRib() {
        Path file = Path.of("../shared/segmentations/example_seg.nii.gz");
        assumeTrue(Files.exists(file), "no ../shared/segmentations here: the real slab is not imported");
        LabelVolume volume = LabelVolumes.read(file);
        assertThat(LabelMap.named(file.toString(), volume).structures()).containsEntry(111, "rib_08_R");
        FittedBody body = body(
                volume,
                new LabelMap(Map.of(
                        5, "liver", 11, "lung_L", 111, "rib_08_R", 115, "rib_12_R", 117, LabelMap.COSTAL_CARTILAGES)));
        double[] liver = body.find("liver").orElseThrow().structure().mesh().bounds();
        double[] leftLung = body.find("lung_L").orElseThrow().structure().mesh().bounds();
        assertThat(liver[0] + liver[3]).isLessThan(leftLung[0] + leftLung[3]);
        assertThat(body.find("costal_cartilage_08_R")).isPresent();
        assertThat(body.find("rib_12_R")
                        .orElseThrow()
                        .scan()
                        .orElseThrow()
                        .meshed()
                        .offLabel()
                        .mean())
                .isLessThan(1.5);
    }
}
