package org.phrenic.patient.segmentation;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.phrenic.patient.label.LabelTable;

/** Parts of an organ that are no specks and lie away from its largest one, in voxels of 3 mm. */
class StrayPartsTest {
    /** Mends an organ of two balls one above the other; returns the notes. */
    private static List<String> mended(String name, double radius, double above, double otherRadius) {
        CageVoxels scan = new CageVoxels();
        scan.ball(40, 30, 30, radius, 1);
        scan.ball(40, 30, 30 + above, otherRadius, 1);
        scan.ball(10, 10, 10, 3, 2);
        return SegmentationRepair.mend(scan.segmentation(new LabelTable(Map.of(1, name, 2, "spleen"))));
    }

    /** Half a millilitre, 120 mm above a gland of 3 ml: a seventh of what carries its label. */
    @Test
    void aSpeckFarFromASmallOrganIsLeftOut() {
        assertThat(mended("adrenal_gland_R", 3, 40, 1.6))
                .containsExactly("parts that lie away from their organ are left out: adrenal_gland_R (0.5 ml)");
    }

    @Test
    void aFarCystOfAKidneyIsKept() {
        assertThat(mended("kidney_cyst_R", 3, 40, 1.6)).isEmpty();
    }

    /** The same near by, as the other limb of a gland that is cut in two. */
    @Test
    void aPartNearerThanTheOrganIsLongIsKept() {
        assertThat(mended("adrenal_gland_R", 3, 11, 1.6)).isEmpty();
    }

    /** Two kidneys under one label, of which one is shrunken. */
    @Test
    void aPartOfAThirdIsKeptHoweverFar() {
        assertThat(mended("kidneys", 5, 45, 4.2)).isEmpty();
    }

    /** Loops and vessels leave the scan between their parts, or their label. */
    @Test
    void farPartsOfBowelAndVesselsAreKept() {
        assertThat(mended("colon", 5, 60, 3)).isEmpty();
        assertThat(mended("colon", 4, 60, 2.4))
                .as("over a tenth, though no loop")
                .isEmpty();
        assertThat(mended("aorta", 3, 40, 1.6)).isEmpty();
    }
}
