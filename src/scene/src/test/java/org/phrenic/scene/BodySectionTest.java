package org.phrenic.scene;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.phrenic.anatomy.StructureKind;

/** What a section shows. */
class BodySectionTest {
    /** A plan may avoid any kind, so each is seen where the needle goes. */
    @Test
    void aSectionShowsEveryKindOfStructureOnce() {
        assertThat(BodySection.PAINTING_ORDER).containsExactlyInAnyOrder(StructureKind.values());
        assertThat(BodySection.PAINTING_ORDER)
                .as("the lung lies within its pleura")
                .containsSubsequence(StructureKind.PLEURA, StructureKind.LUNG);
    }
}
