//! Grey pictures: brightness between pixels, and smaller copies.

use crate::geometry::Point;

/// A grey picture, row by row from the upper left; 0 is black. Places are in pixels, x to the right, y down; the centre of the first pixel is at (0.5, 0.5).
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Picture {
    width: usize,
    height: usize,
    grey: Vec<u8>,
}

impl Picture {
    /// A picture of `width` × `height` pixels; `None` if there are not as many.
    #[must_use]
    pub fn new(width: usize, height: usize, grey: Vec<u8>) -> Option<Picture> {
        (width.checked_mul(height) == Some(grey.len())).then_some(Picture { width, height, grey })
    }

    /// Its width, in pixels.
    #[must_use]
    pub fn width(&self) -> usize {
        self.width
    }

    /// Its height, in pixels.
    #[must_use]
    pub fn height(&self) -> usize {
        self.height
    }

    /// Its pixels, row by row.
    #[must_use]
    pub fn grey(&self) -> &[u8] {
        &self.grey
    }

    pub(super) fn row(&self, y: usize) -> &[u8] {
        &self.grey[y * self.width..][..self.width]
    }

    /// Whether a place has pixels on all sides.
    pub(super) fn holds(&self, at: Point) -> bool {
        (1.0..self.width as f64 - 1.0).contains(&at.x) && (1.0..self.height as f64 - 1.0).contains(&at.y)
    }

    /// Brightness at a place, from the four pixels around it; outside that of the nearest ones.
    #[inline]
    pub(super) fn at(&self, at: Point) -> f64 {
        let within = |x: f64, size: usize| (x - 0.5).max(0.0).min(size as f64 - 1.0);
        let (x, y) = (within(at.x, self.width), within(at.y, self.height));
        let (i, j) = (x as u32 as usize, y as u32 as usize);
        let (u, v) = (x - i as f64, y - j as f64);
        // Beyond the last pixel of a row or column there is none, and its part is 0.
        let right = usize::from(i + 1 < self.width);
        let below = if j + 1 < self.height { self.width } else { 0 };
        let first = j * self.width + i;
        let grey = |further: usize| f64::from(self.grey[first + further]);
        let upper = grey(0) * (1.0 - u) + grey(right) * u;
        upper * (1.0 - v) + (grey(below) * (1.0 - u) + grey(below + right) * u) * v
    }

    /// The picture with means of `factor` × `factor` pixels; what is left over at its right and lower edges is cut off.
    pub(super) fn smaller(&self, factor: usize) -> Picture {
        if factor <= 1 {
            return self.clone();
        }
        let (width, height) = (self.width / factor, self.height / factor);
        let mut grey = Vec::with_capacity(width * height);
        let mut sums = vec![0_u32; width];
        let area = (factor * factor) as u32;
        for y in 0..height {
            sums.fill(0);
            for row in 0..factor {
                let row = self.row(y * factor + row);
                for (sum, pixels) in sums.iter_mut().zip(row.chunks_exact(factor)) {
                    *sum += pixels.iter().map(|&pixel| u32::from(pixel)).sum::<u32>();
                }
            }
            grey.extend(sums.iter().map(|sum| (sum / area) as u8));
        }
        Picture { width, height, grey }
    }
}
