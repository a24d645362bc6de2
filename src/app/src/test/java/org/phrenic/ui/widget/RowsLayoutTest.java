package org.phrenic.ui.widget;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Dimension;
import java.util.List;
import java.util.stream.Stream;
import javax.swing.Box;
import javax.swing.JComponent;
import javax.swing.JPanel;
import org.junit.jupiter.api.Test;

class RowsLayoutTest {
    private final JPanel bar = new JPanel(new RowsLayout(3));
    private final List<JComponent> parts =
            Stream.of(100, 60, 90).map(RowsLayoutTest::part).toList();

    private static JComponent part(int width) {
        JPanel part = new JPanel();
        part.setPreferredSize(new Dimension(width, 20));
        return part;
    }

    private void layOut(int width) {
        bar.add(parts.get(0));
        bar.add(parts.get(1));
        bar.add(Box.createHorizontalGlue());
        bar.add(parts.get(2));
        bar.setSize(width, 100);
        bar.doLayout();
    }

    @Test
    void whatFitsIsOneRowAndGlueTakesTheRest() {
        layOut(300);
        assertThat(bar.getPreferredSize()).isEqualTo(new Dimension(250, 20));
        assertThat(parts.get(1).getX()).isEqualTo(100);
        assertThat(parts.get(2).getX()).isEqualTo(210);
        assertThat(parts).allMatch(part -> part.getY() == 0);
    }

    @Test
    void whatDoesNotFitComesInTheNextRow() {
        layOut(200);
        assertThat(bar.getPreferredSize().height).isEqualTo(43);
        assertThat(parts.get(2).getX()).isZero();
        assertThat(parts.get(2).getY()).isEqualTo(23);
    }
}
