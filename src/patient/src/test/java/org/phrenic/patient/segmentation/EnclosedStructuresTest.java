package org.phrenic.patient.segmentation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.MeshTopology;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.io.volume.LabelVolume;
import org.phrenic.mesh.voxel.LabelGrid;
import org.phrenic.patient.ImportProgress;
import org.phrenic.patient.MeshingSettings;
import org.phrenic.patient.PatientBody;
import org.phrenic.patient.ScanImport;
import org.phrenic.patient.label.LabelGuess;
import org.phrenic.patient.label.LabelTable;

/** A liver of a ball with a vessel through it, a lesion at its surface, and a vena cava beside it; voxels of 2 mm. */
class EnclosedStructuresTest {
    private static final int SIZE = 44;
    private static final double RADIUS = 16;
    private static final int MIDDLE = 20;
    private static final byte LIVER = 1;
    private static final byte VESSEL = 2;
    private static final byte LESION = 3;
    private static final byte CAVA = 4;
    private static final LabelTable TABLE = new LabelTable(Map.of(
            (int) LIVER,
            "liver",
            (int) VESSEL,
            "liver_vessels",
            (int) LESION,
            "lesion_1",
            (int) CAVA,
            "inferior_vena_cava"));

    private static boolean inLiver(int i, int j, int k) {
        return Math.hypot(Math.hypot(i - MIDDLE, j - MIDDLE), k - MIDDLE) <= RADIUS;
    }

    private static byte label(int i, int j, int k) {
        if (inLiver(i, j, k) && Math.hypot(j - MIDDLE, k - MIDDLE) <= 2) {
            return VESSEL;
        }
        // A ball about a point of the surface: half of it lies outside.
        if (Math.hypot(Math.hypot(i - MIDDLE, j - MIDDLE), k - MIDDLE - RADIUS) <= 5) {
            return LESION;
        }
        if (inLiver(i, j, k)) {
            return LIVER;
        }
        return i >= 37 && i <= 40 && Math.abs(j - MIDDLE) <= 2 ? CAVA : 0;
    }

    private static LabelVolume volume() {
        byte[] labels = new byte[SIZE * SIZE * SIZE];
        for (int v = 0; v < labels.length; v++) {
            labels[v] = label(v % SIZE, v / SIZE % SIZE, v / SIZE / SIZE);
        }
        double[] toMm = {2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0};
        return new LabelVolume(LabelGrid.of(SIZE, SIZE, SIZE, labels, toMm), Map.of(), List.of());
    }

    private static int count(LabelGrid grid, int segment) {
        return grid.counts()[segment];
    }

    @Test
    void theLiverHoldsItsVesselsAndTheInnerHalfOfALesionAtItsSurface() {
        Segmentation s = new Segmentation(volume(), TABLE, "volume");
        int vessel = count(s.grid(), s.find("liver_vessels"));
        int lesion = count(s.grid(), s.find("lesion_1"));
        int cava = count(s.grid(), s.find("inferior_vena_cava"));
        EnclosedStructures enclosed = EnclosedStructures.find(s);
        assertThat(enclosed.contains("liver_vessels")).isTrue();
        assertThat(enclosed.contains("inferior_vena_cava")).isFalse();
        assertThat(enclosed.fillOrgans())
                .hasValueSatisfying(note -> assertThat(note).contains("liver_vessels in liver"));
        int ball = 0;
        int lesionWithin = 0;
        for (int v = 0; v < SIZE * SIZE * SIZE; v++) {
            boolean inside = inLiver(v % SIZE, v / SIZE % SIZE, v / SIZE / SIZE);
            ball += inside ? 1 : 0;
            lesionWithin += inside && label(v % SIZE, v / SIZE % SIZE, v / SIZE / SIZE) == LESION ? 1 : 0;
        }
        assertThat(count(s.grid(), s.find("liver"))).isCloseTo(ball, within(ball / 100));
        LabelGrid own = enclosed.ownVoxels().orElseThrow();
        assertThat(count(own, s.find("liver_vessels"))).isEqualTo(vessel);
        assertThat(count(own, s.find("lesion_1"))).isEqualTo(lesion);
        assertThat(count(s.grid(), s.find("inferior_vena_cava"))).isEqualTo(cava);
        assertThat(lesion - lesionWithin).isGreaterThan(lesion / 3);
        assertThat(lesion - count(s.grid(), s.find("lesion_1"))).isCloseTo(lesionWithin, within(lesion / 10));
    }

    @Test
    void surfacesOfAnOrganAndOfWhatLiesInItAreWhole() {
        ImportProgress silent = (count, total, structure) -> {};
        PatientBody body =
                new ScanImport(volume(), "volume", MeshingSettings.PAPER, Optional.empty(), silent).run(TABLE, "body");
        TriangleMesh liver = mesh(body, "liver");
        assertThat(new MeshTopology(liver).eulerCharacteristic()).isEqualTo(2);
        double radiusMm = 2 * RADIUS;
        double ball = 4.0 / 3 * Math.PI * radiusMm * radiusMm * radiusMm;
        assertThat(MeshMeasure.signedVolume(liver)).isCloseTo(ball, within(0.03 * ball));
        TriangleMesh vessel = mesh(body, "liver_vessels");
        double[] bounds = vessel.bounds();
        assertThat(bounds[3] - bounds[0]).isCloseTo(2 * radiusMm, within(8.0));
    }

    /** A ring of a plan takes no part of the liver, and is no structure of the body. */
    @Test
    void anAidOfAPlanIsLeftOutAndTheLiverIsWhole() {
        Map<Integer, String> names = Map.of(1, "Liver", 2, "Ring_2cm", 3, "GTV", 4, "IVC");
        LabelVolume plan = new LabelVolume(volume().grid(), names, List.of());
        ImportProgress silent = (count, total, structure) -> {};
        PatientBody body = new ScanImport(plan, "plan", MeshingSettings.PAPER, Optional.empty(), silent)
                .run(LabelGuess.of(plan).require("plan"), "body");
        assertThat(body.structures())
                .extracting(s -> s.structure().name())
                .containsExactly("inferior_vena_cava", "lesion_gtv", "liver");
        assertThat(body.notes())
                .contains("margins and aids of a radiotherapy plan, left out: Ring_2cm")
                .noneMatch(note -> note.contains("kept as obstacles"));
        double ball = 4.0 / 3 * Math.PI * Math.pow(2 * RADIUS, 3);
        assertThat(MeshMeasure.signedVolume(mesh(body, "liver"))).isCloseTo(ball, within(0.03 * ball));
    }

    /**
     * A ball of isodose between liver and stomach and a rind at the outline, as a folder of masks paints them: the
     * least masks take the voxels. Every organ and the outline are as they are without them.
     */
    @Test
    void anAidOfAPlanBitesOutOfNoOrganNorOutOfTheOutline() {
        byte[] plain = new byte[SIZE * SIZE * SIZE];
        byte[] planned = new byte[plain.length];
        for (int v = 0; v < plain.length; v++) {
            int i = v % SIZE;
            int j = v / SIZE % SIZE;
            int k = v / SIZE / SIZE;
            boolean body = i >= 3 && i < SIZE - 3 && j >= 3 && j < SIZE - 3;
            boolean organ = i >= 8 && i < 36 && j >= 8 && j < 36 && k >= 6 && k < 38;
            plain[v] = (byte) (organ && i < 22 ? 1 : organ ? 2 : body ? 3 : 0);
            boolean isodose = Math.hypot(Math.hypot(i - 22, j - 20), k - 20) <= 8;
            boolean rind = body && i < 5 && Math.abs(j - 20) <= 6 && k >= 30;
            planned[v] = (byte) (isodose ? 4 : rind ? 5 : plain[v]);
        }
        double[] toMm = {2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0};
        Map<Integer, String> names = Map.of(1, "Liver", 2, "Stomach", 3, "Body", 4, "Isodose_20Gy", 5, "Chestwall");
        ImportProgress silent = (count, total, structure) -> {};
        List<PatientBody> bodies = Stream.of(plain, planned)
                .map(labels -> new LabelVolume(LabelGrid.of(SIZE, SIZE, SIZE, labels, toMm), names, List.of()))
                .map(plan -> new ScanImport(plan, "plan", MeshingSettings.PAPER, Optional.empty(), silent)
                        .run(LabelGuess.of(plan).require("plan"), "body"))
                .toList();
        for (String name : List.of("liver", "stomach", "skin")) {
            double whole = MeshMeasure.signedVolume(mesh(bodies.get(0), name));
            assertThat(MeshMeasure.signedVolume(mesh(bodies.get(1), name)))
                    .as(name)
                    .isCloseTo(whole, within(0.005 * whole));
        }
        assertThat(bodies.get(1).structures()).hasSize(3);
    }

    private static TriangleMesh mesh(PatientBody body, String name) {
        return body.structures().stream()
                .filter(s -> s.structure().name().equals(name))
                .findFirst()
                .orElseThrow()
                .structure()
                .mesh();
    }

    @Test
    void vesselsUnderTheNameOfBothLungsGoToTheLungAboutThem() {
        byte[] labels = new byte[30 * 10 * 10];
        for (int v = 0; v < labels.length; v++) {
            int i = v % 30;
            int j = v / 30 % 10;
            int k = v / 300;
            boolean lung = i != 14 && i != 15;
            boolean tree = j == 5 && k == 5;
            labels[v] = (byte) (!lung ? 0 : tree ? 3 : i < 14 ? 1 : 2);
        }
        LabelVolume volume = new LabelVolume(
                LabelGrid.of(30, 10, 10, labels, new double[] {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0}),
                Map.of(),
                List.of());
        Segmentation s =
                new Segmentation(volume, new LabelTable(Map.of(1, "lung_R", 2, "lung_L", 3, LabelTable.LUNGS)), "v");
        assertThat(LungSplitter.split(s, new ArrayList<>())).isEmpty();
        assertThat(count(s.grid(), s.find("lung_R"))).isEqualTo(14 * 100);
        assertThat(count(s.grid(), s.find("lung_L"))).isEqualTo(14 * 100);
    }

    /** Vessels of the right lung of a patient without a left one, then the left lung itself under that name. */
    @Test
    void besideOneLungVesselsAreOfItAndALargeBodyIsTheOther() {
        byte[] labels = new byte[30 * 10 * 10];
        for (int v = 0; v < labels.length; v++) {
            boolean tree = v / 30 % 10 == 5 && v / 300 == 5;
            labels[v] = (byte) (v % 30 >= 14 ? 0 : tree ? 3 : 1);
        }
        Segmentation alone = oneLung(labels);
        assertThat(LungSplitter.split(alone, new ArrayList<>())).isEmpty();
        assertThat(count(alone.grid(), alone.find("lung_R"))).isEqualTo(14 * 100);
        assertThat(alone.find("lung_L")).isZero();
        for (int v = 0; v < labels.length; v++) {
            labels[v] = v % 30 > 15 ? 3 : labels[v];
        }
        Segmentation both = oneLung(labels);
        assertThat(LungSplitter.split(both, new ArrayList<>())).isEmpty();
        assertThat(count(both.grid(), both.find("lung_R"))).isEqualTo(14 * 100);
        assertThat(count(both.grid(), both.find("lung_L"))).isEqualTo(14 * 100);
    }

    private static Segmentation oneLung(byte[] labels) {
        LabelVolume volume = new LabelVolume(
                LabelGrid.of(30, 10, 10, labels, new double[] {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0}),
                Map.of(),
                List.of());
        return new Segmentation(volume, new LabelTable(Map.of(1, "lung_R", 3, LabelTable.LUNGS)), "v");
    }
}
