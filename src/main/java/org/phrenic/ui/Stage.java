package org.phrenic.ui;

import java.awt.Component;
import java.awt.Dimension;
import javax.swing.JComponent;
import javax.swing.JLayeredPane;

/** The view, and over it what comes and goes: a banner at the top, how far loading is at the bottom, the welcome card above that. */
final class Stage extends JLayeredPane {
    private static final int MARGIN = 14;
    private static final int FOOT = 34;
    private static final int WIDEST_BANNER = 620;

    private final JComponent view;
    private final Banner banner;
    private final LoadingCard loading;
    private final WelcomeCard welcome;

    Stage(JComponent view, Banner banner, LoadingCard loading, WelcomeCard welcome) {
        this.view = view;
        this.banner = banner;
        this.loading = loading;
        this.welcome = welcome;
        add(view, DEFAULT_LAYER);
        add(welcome, PALETTE_LAYER);
        add(loading, PALETTE_LAYER);
        add(banner, MODAL_LAYER);
        setMinimumSize(view.getMinimumSize());
    }

    @Override
    public Dimension getPreferredSize() {
        return new Dimension(640, 480);
    }

    @Override
    public boolean isOptimizedDrawingEnabled() {
        return false;
    }

    @Override
    public void doLayout() {
        int w = getWidth();
        int h = getHeight();
        view.setBounds(0, 0, w, h);
        Dimension b = banner.getPreferredSize();
        int wide = Math.max(0, Math.min(Math.min(WIDEST_BANNER, b.width), w - 2 * MARGIN));
        banner.setBounds((w - wide) / 2, MARGIN, wide, b.height);
        int foot = h - FOOT;
        foot = rise(welcome, foot);
        rise(loading, foot);
    }

    /** Puts a card in the middle above {@code foot}; returns what is above it then. */
    private int rise(Component card, int foot) {
        Dimension size = card.getPreferredSize();
        int wide = Math.max(0, Math.min(size.width, getWidth() - 2 * MARGIN));
        card.setBounds((getWidth() - wide) / 2, foot - size.height, wide, size.height);
        return card.isVisible() ? foot - size.height - MARGIN / 2 : foot;
    }
}
