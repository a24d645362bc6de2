package org.phrenic.ui.access.panel;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Path;
import javax.swing.JComboBox;
import javax.swing.JSpinner;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.phrenic.access.TargetLesion;
import org.phrenic.anatomy.MeshBudget;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.Thorax;
import org.phrenic.anatomy.virtual.VirtualThorax;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.io.MeshFiles;
import org.phrenic.ui.window.WindowHarness;

/** A body with two tumours in its liver: they can be chosen as targets. */
@Timeout(120)
class LesionTargetTest {
    private static final double SMALL = 0.06;
    private static final double LARGE = 0.12;
    private static final MeshBudget COARSE = new MeshBudget(2000);

    @TempDir
    private static Path folder;

    /** The liver made smaller about a place that lies within it. */
    private static TriangleMesh tumour(TriangleMesh liver, double scale, double right) {
        double[] about = MeshMeasure.centreOfMass(liver);
        about[0] -= right;
        double[] p = liver.positions().clone();
        for (int i = 0; i < p.length; i++) {
            p[i] = about[i % 3] + scale * (p[i] - about[i % 3]);
        }
        return liver.withPositions(p);
    }

    @Test
    void theLargestLesionIsTheTargetAndAnotherIsChosenFromTheList() throws Exception {
        WindowHarness.assumeDisplay();
        Thorax man = VirtualThorax.ofPreset("adult-male", COARSE);
        for (Structure s : man.structures()) {
            MeshFiles.write(folder.resolve(s.name() + ".ply"), s.mesh());
        }
        TriangleMesh liver = man.find("liver").orElseThrow().mesh();
        MeshFiles.write(folder.resolve("liver_tumor.ply"), tumour(liver, SMALL, 0));
        MeshFiles.write(folder.resolve("lesion_cyst.ply"), tumour(liver, LARGE, 35));
        RehearsalHarness clinic = new RehearsalHarness("lesions", "anatomy=" + folder);
        try {
            assertThat(target(clinic).diameterMm())
                    .isCloseTo(LARGE * Math.cbrt(6 / Math.PI * MeshMeasure.signedVolume(liver)), within(0.1));
            JComboBox<?> lesions = clinic.window().control(JComboBox.class, "Lesion");
            assertThat(WindowHarness.onEdt(() -> lesions.getSelectedItem().toString()))
                    .startsWith("cyst, ");
            assertThat(WindowHarness.onEdt(lesions::getItemCount)).isEqualTo(3);
            WindowHarness.doOnEdt(() -> lesions.setSelectedIndex(1));
            clinic.until("the other lesion", () -> target(clinic).diameterMm() < 20);
            clinic.ready();
            assertThat(target(clinic).restMm())
                    .containsExactly(MeshMeasure.centreOfMass(tumour(liver, SMALL, 0)), within(0.01));
            clinic.window().screenshot("rehearse-lesion");
            JSpinner size = clinic.window().control(JSpinner.class, "Diameter of the target");
            WindowHarness.doOnEdt(() -> size.setValue(30));
            clinic.until("a larger target", () -> target(clinic).diameterMm() == 30);
            clinic.ready();
            assertThat(WindowHarness.onEdt(() -> lesions.getSelectedItem().toString()))
                    .as("a target of another size is not the lesion")
                    .startsWith("another target");
        } finally {
            clinic.window().close();
        }
    }

    private static TargetLesion target(RehearsalHarness clinic) {
        return WindowHarness.onEdt(
                () -> clinic.rehearsal().study().map(study -> study.target()).orElseThrow());
    }
}
