package org.phrenic.ui.access.panel;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Graphics2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.phrenic.access.plan.PathAdvice;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.scene.BodySection;
import org.phrenic.ui.session.EventThread;
import org.phrenic.ui.widget.Theme;

/** Headings, letters and scale of the sections. */
class SectionViewTest {
    private static final int SIDE = 240;

    /** Before the needle is in, the section across it is cut where it is to go. */
    @Test
    void theHeadingOfTheSectionAcrossSaysWhereItIsCut() {
        EventThread.run(() -> {
            SectionView across = new SectionView("At the tip", 36, true);
            BodySection section = section();
            across.show(section, PathAdvice.Level.FREE, false, "");
            assertThat(across.heading()).isEqualTo("At the target");
            across.show(section, PathAdvice.Level.FREE, true, "");
            assertThat(across.heading()).isEqualTo("At the tip");
        });
    }

    /** The bar lies on whatever is cut there; below it is a liver as dark as the bar. */
    @Test
    void theScaleBarCanBeSeenOnTheLiver() {
        BufferedImage painted = new BufferedImage(SIDE, SIDE, BufferedImage.TYPE_INT_RGB);
        EventThread.run(() -> {
            Theme.install(false);
            SectionView across = new SectionView("At the tip", 36, true);
            across.setSize(SIDE, SIDE);
            across.show(section(), PathAdvice.Level.FREE, true, "");
            Graphics2D g = painted.createGraphics();
            across.paint(g);
            g.dispose();
        });
        int below = painted.getRGB(SIDE - 20, SIDE - 9);
        assertThat(below >> 8 & 0xff).as("the halo below the bar").isGreaterThan(150);
    }

    private static BodySection section() {
        Path2D all = new Path2D.Double(new Rectangle2D.Double(-50, -50, 100, 100));
        return new BodySection(
                List.of(new BodySection.Part(StructureKind.LIVER, all, 0x602020)),
                new double[2],
                new double[2],
                new double[2],
                new double[2],
                10,
                0,
                "L",
                "A");
    }

    /** A radiological axial section: the patient's left on the right of the picture, anterior at the top. */
    @Test
    void oppositeEdgesHaveOppositeLetters() {
        assertThat(SectionView.EdgeLetters.of("L", "A")).isEqualTo(new SectionView.EdgeLetters("R", "L", "A", "P"));
    }
}
