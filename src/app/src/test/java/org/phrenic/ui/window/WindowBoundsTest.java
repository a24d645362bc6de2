package org.phrenic.ui.window;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Rectangle;
import java.util.List;
import org.junit.jupiter.api.Test;

/** The window opens where it was closed, if that can be seen. */
class WindowBoundsTest {
    private static final Rectangle FIRST = new Rectangle(0, 0, 1600, 1000);
    private static final Rectangle LEFT = new Rectangle(-1920, 0, 1920, 1080);
    private static final List<Rectangle> TWO = List.of(FIRST, LEFT);

    @Test
    void aWindowStaysOnTheScreenWhereItWasClosed() {
        Rectangle second = new Rectangle(-1800, 100, 1200, 800);
        assertThat(WindowBounds.onScreen(second, TWO)).isEqualTo(second);
        Rectangle first = new Rectangle(100, 100, 1200, 800);
        assertThat(WindowBounds.onScreen(first, TWO)).isEqualTo(first);
        Rectangle both = new Rectangle(-600, 50, 1500, 900);
        assertThat(WindowBounds.onScreen(both, TWO)).isEqualTo(both);
    }

    @Test
    void aWindowOfAScreenThatIsGoneComesToTheFirst() {
        Rectangle shown = WindowBounds.onScreen(new Rectangle(-1800, 100, 1200, 800), List.of(FIRST));
        assertThat(FIRST.contains(shown)).isTrue();
        assertThat(shown.width).isGreaterThan(1000);
    }

    /** Of the window at the right edge 20 pixels can be seen, of that above the edge all but the title bar. */
    @Test
    void aWindowWhoseTitleBarCannotBeGraspedIsMovedOntoItsScreen() {
        assertThat(WindowBounds.onScreen(new Rectangle(1580, 100, 1200, 800), TWO))
                .isEqualTo(new Rectangle(400, 100, 1200, 800));
        assertThat(WindowBounds.onScreen(new Rectangle(-3000, 990, 1200, 80), TWO))
                .isEqualTo(new Rectangle(-1920, 990, 1200, 80));
        assertThat(WindowBounds.onScreen(new Rectangle(100, -200, 1200, 800), TWO))
                .isEqualTo(new Rectangle(100, 0, 1200, 800));
        Rectangle aLittleOutside = new Rectangle(1200, -8, 1200, 800);
        assertThat(WindowBounds.onScreen(aLittleOutside, TWO)).isEqualTo(aLittleOutside);
    }

    @Test
    void aWindowLargerThanItsScreenIsMadeSmaller() {
        assertThat(WindowBounds.onScreen(new Rectangle(-1900, 200, 3000, 700), TWO))
                .isEqualTo(new Rectangle(-1920, 200, 1920, 700));
        assertThat(WindowBounds.onScreen(new Rectangle(50, 40, 2560, 1440), List.of(FIRST)))
                .isEqualTo(FIRST);
    }
}
