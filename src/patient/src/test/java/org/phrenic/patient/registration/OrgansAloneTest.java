package org.phrenic.patient.registration;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.phrenic.anatomy.Resolution;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.Thorax;
import org.phrenic.anatomy.virtual.VirtualThorax;
import org.phrenic.mesh.Shapes;
import org.phrenic.patient.ExpectedStructures;
import org.phrenic.patient.PatientBody;
import org.phrenic.patient.PatientStructure;

/**
 * Of the virtual woman a scan shows organs of the abdomen alone, as the labels of many data sets do. Her liver lies 20
 * mm farther in front of the other organs and of the spine than the template's.
 */
class OrgansAloneTest {
    private static final double BEHIND_MM = 20;
    private static final Set<String> SHOWN = Set.of("spleen", "kidney_R", "kidney_L", "aorta", "inferior_vena_cava");

    private static Thorax woman;
    private static PatientBody body;

    @BeforeAll
    static void complete() {
        woman = VirtualThorax.ofPreset("adult-female", Resolution.LOW);
        body = completed(0, VirtualThorax.ofPreset("adult-male", Resolution.LOW));
    }

    private static Structure moved(Structure s, double y, double z) {
        return s.withMesh(Shapes.moved(s.mesh(), 0, y, z));
    }

    /** @param loweredMm how much lower than hers the kidneys lie */
    private static PatientBody completed(double loweredMm, Thorax template) {
        List<PatientStructure> organs = new ArrayList<>();
        organs.add(BodyCompletionTest.scanned(woman.find("liver").orElseThrow(), ""));
        for (Structure s : woman.organs().get()) {
            if (SHOWN.contains(s.name())) {
                double z = s.name().startsWith("kidney") ? -loweredMm : 0;
                organs.add(BodyCompletionTest.scanned(moved(s, BEHIND_MM, z), ""));
            }
        }
        return BodyCompletion.complete(
                new PatientBody("patient", organs, ExpectedStructures.missing(organs), List.of()), template);
    }

    /** The virtual man as a thorax folder has him, whose organs are structures as all others; those of the scan. */
    private static Thorax ofFolder() {
        Thorax man = VirtualThorax.ofPreset("adult-male", Resolution.LOW);
        List<Structure> all = new ArrayList<>(man.structures());
        man.organs().get().stream().filter(s -> SHOWN.contains(s.name())).forEach(all::add);
        return new Thorax(man.name(), all, man.notes());
    }

    /** Mean place of the vertebrae from T10 to L2 less that of hers. */
    private static double[] spineOff(PatientBody body) {
        double[] off = new double[3];
        int count = 0;
        for (Structure s : woman.structuresOf(StructureKind.VERTEBRA)) {
            if (s.level() >= 10 && s.level() <= 14) {
                double[] is = body.thorax().find(s.name()).orElseThrow().mesh().centre();
                double[] was = s.mesh().centre();
                for (int k = 0; k < 3; k++) {
                    off[k] += is[k] - was[k];
                }
                count++;
            }
        }
        return new double[] {off[0] / count, off[1] / count, off[2] / count};
    }

    @Test
    void theSpineLiesBehindKidneysAndVesselsAndTheCageAboutTheLiver() {
        double[] off = spineOff(body);
        assertThat(off[0]).as("to the left, mm").isCloseTo(0, within(3.0));
        assertThat(off[1]).as("to the back, mm").isCloseTo(BEHIND_MM, within(8.0));
        assertThat(off[2]).as("upward, mm").isCloseTo(0, within(8.0));
        assertThat(body.canBreathe()).isTrue();
        assertThat(body.notes())
                .anyMatch(note -> note.endsWith(
                        "structures come from adult-male, brought to the 6 that it shares with the scan"));
        assertThat(body.structures())
                .filteredOn(s -> SHOWN.contains(s.structure().name()))
                .hasSize(SHOWN.size())
                .allMatch(s -> s.source() == PatientStructure.Source.SCAN);
    }

    /**
     * In a breath the kidneys go down less than the liver: what tells how high the spine is are liver and spleen. All
     * organs tell how far behind the liver it lies, also those of a template from a folder.
     */
    @Test
    void kidneysDoNotTellHowHighTheSpineIs() {
        PatientBody lowered = completed(30, ofFolder());
        assertThat(spineOff(lowered)[2] - spineOff(body)[2]).isCloseTo(0, within(3.0));
        assertThat(spineOff(lowered)[1] - spineOff(body)[1]).isCloseTo(0, within(3.0));
        assertThat(lowered.notes()).anyMatch(note -> note.endsWith("brought to the 6 that it shares with the scan"));
    }
}
