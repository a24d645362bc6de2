package org.phrenic.ui.access.panel;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class SectionViewTest {
    /** A radiological axial section: the patient's left on the right of the picture, anterior at the top. */
    @Test
    void oppositeEdgesHaveOppositeLetters() {
        assertThat(SectionView.EdgeLetters.of("L", "A")).isEqualTo(new SectionView.EdgeLetters("R", "L", "A", "P"));
    }
}
