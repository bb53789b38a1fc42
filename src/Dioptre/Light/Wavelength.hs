-- |
-- Module      : Dioptre.Light.Wavelength
-- Description : The colour of a wavelength
--
-- What the eye sees of light of one wavelength, as red, green and blue: the eye's response (the colour matching
-- functions of the CIE's standard observer of 1931, as sums of lobes), then the screen's primaries, then its transfer
-- curve. Sources: C. Wyman, P.-P. Sloan, P. Shirley, "Simple analytic approximations to the CIE XYZ color matching
-- functions", JCGT 2(2), 2013; IEC 61966-2-1 (sRGB).
module Dioptre.Light.Wavelength
  ( colourOfWavelength,
  )
where

import Dioptre.Light.Colour (Colour, rgb)

-- $setup
-- >>> import Dioptre.Light.Colour (Colour (..))

-- | The colour of light of that wavelength, in nanometres (380 to 780 is visible); every channel is from 0 to 1.
--
-- >>> [round (255 * channel (colourOfWavelength 450)) | channel <- [red, green, blue]]
-- [116,0,255]
--
-- Spec: numbers.elementary, light.wave.colour.
colourOfWavelength :: Double -> Colour
colourOfWavelength l = rgb (channel red) (channel green) (channel blue)
  where
    x = 0.362 * lobe 442 0.0624 0.0374 + 1.056 * lobe 599.8 0.0264 0.0323 - 0.065 * lobe 501.1 0.0490 0.0382
    y = 0.821 * lobe 568.8 0.0213 0.0247 + 0.286 * lobe 530.9 0.0613 0.0322
    z = 1.217 * lobe 437 0.0845 0.0278 + 0.681 * lobe 459 0.0385 0.0725
    red = 3.2406255 * x - 1.537208 * y - 0.4986286 * z
    green = -0.9689307 * x + 1.8757561 * y + 0.0415175 * z
    blue = 0.0557101 * x - 0.2040211 * y + 1.0569959 * z
    -- A Gaussian with one width below its centre and another above.
    lobe centre below above = exp (-0.5 * w * w)
      where
        w = (l - centre) * (if l < centre then below else above)
    channel c = transfer (if c < 0 then 0 else if c > 1 then 1 else c)
    transfer c
      | c <= 0.0031308 = 12.92 * c
      | otherwise = 1.055 * c ** (1 / 2.4) - 0.055
