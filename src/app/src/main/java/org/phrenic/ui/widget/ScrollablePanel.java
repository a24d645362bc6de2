package org.phrenic.ui.widget;

import java.awt.Dimension;
import java.awt.Rectangle;
import javax.swing.BorderFactory;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.ScrollPaneConstants;
import javax.swing.Scrollable;
import net.miginfocom.swing.MigLayout;

/** A panel in a scroll pane: as wide as the viewport, and as high where it needs less. */
public class ScrollablePanel extends JPanel implements Scrollable {
    public ScrollablePanel() {
        this(new MigLayout("insets 0 0 8 0, fillx, hidemode 3, gapy 0, wrap 1", "[grow,fill]"));
    }

    public ScrollablePanel(MigLayout layout) {
        super(layout);
    }

    /** A scroll pane for a panel: no border, vertical scrolling only. */
    public static JScrollPane scrollPane(JPanel body) {
        JScrollPane scroll = new JScrollPane(
                body, ScrollPaneConstants.VERTICAL_SCROLLBAR_AS_NEEDED, ScrollPaneConstants.HORIZONTAL_SCROLLBAR_NEVER);
        // Not null, which a change of the theme would replace.
        scroll.setBorder(BorderFactory.createEmptyBorder());
        return scroll;
    }

    @Override
    public Dimension getPreferredScrollableViewportSize() {
        return getPreferredSize();
    }

    @Override
    public int getScrollableUnitIncrement(Rectangle visible, int orientation, int direction) {
        return getFontMetrics(getFont()).getHeight();
    }

    @Override
    public int getScrollableBlockIncrement(Rectangle visible, int orientation, int direction) {
        return visible.height;
    }

    @Override
    public boolean getScrollableTracksViewportWidth() {
        return true;
    }

    @Override
    public boolean getScrollableTracksViewportHeight() {
        return getParent() != null && getParent().getHeight() > getPreferredSize().height;
    }
}
