package org.phrenic.ui.window;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Dimension;
import javax.swing.JComponent;
import javax.swing.JLayeredPane;

/**
 * The welcome panel above the view, and over the view the message banner at the top and the progress of an import and
 * of loading at the bottom.
 */
final class OverlayPane extends JLayeredPane {
    private static final int MARGIN = 14;
    private static final int BOTTOM_MARGIN = 34;
    /** Below the letter of the upper side and the time, which stay in sight, pixels. */
    private static final int BANNER_TOP = 44;

    private final JComponent view;
    private final MessageBanner banner;
    private final LoadingPanel loading;
    private final LoadingPanel importing;
    private final WelcomePanel welcome;

    OverlayPane(
            JComponent view, MessageBanner banner, LoadingPanel loading, LoadingPanel importing, WelcomePanel welcome) {
        this.view = view;
        this.banner = banner;
        this.loading = loading;
        this.importing = importing;
        this.welcome = welcome;
        add(view, DEFAULT_LAYER);
        add(welcome, PALETTE_LAYER);
        add(loading, PALETTE_LAYER);
        add(importing, PALETTE_LAYER);
        add(banner, MODAL_LAYER);
        setMinimumSize(view.getMinimumSize());
    }

    @Override
    public Dimension getPreferredSize() {
        return new Dimension(640, 480);
    }

    /** The least size of the view, and the welcome panel above it. */
    @Override
    public Dimension getMinimumSize() {
        Dimension least = super.getMinimumSize();
        return new Dimension(least.width, least.height + welcomeHeight());
    }

    private int welcomeHeight() {
        return welcome.isVisible() ? welcome.getPreferredSize().height : 0;
    }

    @Override
    public boolean isOptimizedDrawingEnabled() {
        return false;
    }

    @Override
    public void doLayout() {
        int w = getWidth();
        int h = getHeight();
        int top = welcomeHeight();
        welcome.setBounds(0, 0, w, top);
        view.setBounds(0, top, w, Math.max(0, h - top));
        banner.fit(w - 2 * MARGIN);
        Dimension b = banner.getPreferredSize();
        int wide = Math.max(0, Math.min(b.width, w - 2 * MARGIN));
        banner.setBounds((w - wide) / 2, top + UIScale.scale(BANNER_TOP), wide, b.height);
        Dimension l = loading.getPreferredSize();
        wide = Math.max(0, Math.min(l.width, w - 2 * MARGIN));
        loading.setBounds((w - wide) / 2, h - BOTTOM_MARGIN - l.height, wide, l.height);
        importing.setBounds((w - wide) / 2, h - BOTTOM_MARGIN - 2 * l.height - MARGIN, wide, l.height);
    }
}
