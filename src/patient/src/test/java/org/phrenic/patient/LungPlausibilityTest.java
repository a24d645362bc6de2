package org.phrenic.patient;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.phrenic.anatomy.Resolution;
import org.phrenic.anatomy.virtual.VirtualThorax;
import org.phrenic.mesh.io.volume.LabelVolume;
import org.phrenic.mesh.voxel.LabelGrid;
import org.phrenic.patient.label.GeometryOverride;
import org.phrenic.patient.label.LabelTable;

/** The sample's right lung is the larger one, above its liver. */
class LungPlausibilityTest {
    private static final String LARGER = "the left lung is larger than the right";
    private static final String OTHER_SIDE = "liver on the other side than in most people: situs inversus";

    private static final Map<Integer, String> LUNGS = Map.of(ScanSamples.LUNGS, LabelTable.LUNGS);
    private static final Map<Integer, String> LIVER_TOO =
            Map.of(ScanSamples.LUNGS, LabelTable.LUNGS, ScanSamples.LIVER, "liver");

    private static String notes(LabelVolume volume, Map<Integer, String> structures) {
        return String.join(
                "\n",
                new ScanImport(volume, "scan", MeshingSettings.PAPER, Optional.empty(), (n, of, what) -> {})
                        .run(new LabelTable(structures), "body")
                        .notes());
    }

    /** A mirrored scan shows by the volumes of lungs alone, or by the side of the liver. */
    @Test
    void aMirroredScanIsRemarkedOn() {
        LabelVolume mirrored = GeometryOverride.axes(ScanSamples.volume(), "RPS");
        assertThat(notes(mirrored, LUNGS)).contains(LARGER, "--axes").doesNotContain(OTHER_SIDE);
        assertThat(notes(mirrored, LIVER_TOO)).contains(OTHER_SIDE, "--axes").doesNotContain(LARGER);
    }

    /** Lungs of which the left one is larger, above a liver on the right. */
    @Test
    void aLargeLeftLungIsNotRemarkedOnWhereTheLiverIsOnTheRight() {
        byte[] sample = ScanSamples.voxels();
        byte[] labels = new byte[sample.length];
        for (int v = 0; v < labels.length; v++) {
            int i = v % ScanSamples.COLUMNS;
            boolean lung = sample[v - i + ScanSamples.COLUMNS - 1 - i] == ScanSamples.LUNGS;
            labels[v] = lung ? ScanSamples.LUNGS : sample[v] == ScanSamples.LIVER ? sample[v] : 0;
        }
        double s = ScanSamples.SPACING_MM;
        LabelVolume scan = new LabelVolume(
                LabelGrid.of(ScanSamples.COLUMNS, ScanSamples.ROWS, ScanSamples.SLICES, labels, new double[] {
                    s, 0, 0, 0, 0, s, 0, 0, 0, 0, s, 0
                }),
                Map.of(),
                List.of());
        assertThat(notes(scan, LUNGS)).contains(LARGER);
        assertThat(notes(scan, LIVER_TOO)).doesNotContain(LARGER).doesNotContain(OTHER_SIDE);
    }

    @Test
    void theSampleIsPlausible() {
        assertThat(notes(ScanSamples.volume(), LIVER_TOO))
                .doesNotContain(LARGER)
                .doesNotContain(OTHER_SIDE);
    }

    /** The woman's lungs are 1.2 times as tall as deep, and as deep again for a box of LPS where she lies turned. */
    @Test
    void aTurnedBodyHasTheProportionsOfAStraightOne() {
        for (double degrees : new double[] {0, 20, -30}) {
            assertThat(LungPlausibility.check(turned(degrees, 1)))
                    .as("turned by " + degrees)
                    .isEmpty();
            assertThat(LungPlausibility.check(turned(degrees, 0.7)))
                    .as("turned by " + degrees)
                    .singleElement()
                    .asString()
                    .contains("is the spacing right?");
        }
    }

    /** The virtual woman turned about the body's axis, with slices of another distance. */
    private static List<PatientStructure> turned(double degrees, double height) {
        double cos = StrictMath.cos(StrictMath.toRadians(degrees));
        double sin = StrictMath.sin(StrictMath.toRadians(degrees));
        return VirtualThorax.ofPreset("adult-female", Resolution.LOW).structures().stream()
                .map(s -> {
                    double[] p = s.mesh().positions().clone();
                    for (int i = 0; i < p.length; i += 3) {
                        double x = p[i];
                        p[i] = cos * x - sin * p[i + 1];
                        p[i + 1] = sin * x + cos * p[i + 1];
                        p[i + 2] *= height;
                    }
                    return new PatientStructure(
                            s.withMesh(s.mesh().withPositions(p)),
                            PatientStructure.Source.SCAN,
                            Optional.empty(),
                            Optional.empty());
                })
                .toList();
    }
}
