-- |
-- Module      : Dioptre
-- Description : The whole program in one expression
--
-- A picture is a function of a text:
--
-- @
-- 'draw' = 'rendered' . 'plan' mempty 'noModels' . fst . 'checkScene' . 'parse'
-- @
--
-- The scene language is that of an older program, which comments call the original; the handout is the text that comes
-- with it, and asks what students find out. Where Dioptre differs, "Dioptre.Scene.Original" tells.
--
-- Each name is the door of a folder. The folders are stages, and here they stand in the order in which they import each
-- other, always an earlier one; reading them in this order is a course in ray tracing.
--
-- [Source] Bytes become text with lines and columns ("Dioptre.Source.Text"). What can be wrong with a text is data
-- ("Dioptre.Source.Diagnostic"); its words stand apart, in two languages ("Dioptre.Source.Message").
--
-- [Syntax] Text becomes a tree of objects and properties ("Dioptre.Syntax.Grammar", "Dioptre.Syntax.Value").
--
-- [Math] Vectors, transformations, and the roots of polynomials up to degree four ("Dioptre.Math.Roots").
--
-- [Geometry] Rays and shapes: where a ray meets a sphere is "Dioptre.Math.Roots" at work in "Dioptre.Geometry.Sphere".
-- Many shapes stand in boxes ("Dioptre.Geometry.Hierarchy").
--
-- [Optics] Reflection and refraction.
--
-- [Light] Colours, materials, lights, and what a surface sends back ("Dioptre.Light.Illumination").
--
-- [Scene] The tree becomes a checked scene ("Dioptre.Scene.Check"), by a description of each object
-- ("Dioptre.Scene.Schema") that also writes it back.
--
-- [Model] Models come from files of four formats to one thing ("Dioptre.Model.Content"), each once
-- ("Dioptre.Model.Library"). A scene of text alone has 'noModels', and none of the pictures for textures, which are the
-- @mempty@.
--
-- [Picture] Colours become bytes ("Dioptre.Picture.Byte"), and bytes a file ("Dioptre.Picture.Png").
--
-- [Render] The scene becomes a plan, and the plan rows of pixels: the camera ("Dioptre.Render.View"), what a ray meets
-- first ("Dioptre.Render.Closest") and what it sees there ("Dioptre.Render.Radiance"), one row ("Dioptre.Render.Row"),
-- all of them in parallel ("Dioptre.Render.Parallel").
--
-- [Explain] The story of one pixel, as data ("Dioptre.Explain.Story").
--
-- Everything so far is pure, but for the workers. What touches the world stands at the end:
--
-- [Files] Whole files or none ("Dioptre.Files.Whole"), and the numbers of pictures.
--
-- [Load] A scene with the models and pictures that it names.
--
-- [View] The live viewer, a server for one page.
--
-- [Conformance] The rules as questions and answers: the oracle, and the suite for ports.
--
-- [Command] What the program does when it is asked by name.
--
-- As a library, in a program, which reads a scene, tells what is wrong with it, and writes its picture:
--
-- > import qualified Data.ByteString as Bytes
-- > import qualified Data.ByteString.Lazy as Lazy
-- > import Dioptre
-- >
-- > main :: IO ()
-- > main = do
-- >   source <- decode "scene.txt" <$> Bytes.readFile "scene.txt"
-- >   mapM_ (print . pretty English source) (complaints source)
-- >   Lazy.writeFile "scene.png" (encode (draw source))
--
-- (A scene that names pictures or models needs those files as well: "Dioptre.Load" reads a scene with all of them.)
--
-- And in GHCi:
--
-- >>> :set -XOverloadedStrings
-- >>> import Dioptre
-- >>> pictureWidth (draw (fromText "scene.txt" "viewport\nwidth 40\nend"))
-- 40
-- >>> map (code . diagnosticProblem) (complaints (fromText "scene.txt" "viewport\nwidht 40\nend"))
-- ["unknown-word"]
module Dioptre
  ( -- * The whole program
    draw,
    complaints,

    -- * Its stages
    decode,
    fromText,
    parse,
    checkScene,
    plan,
    noModels,
    rendered,
    encode,

    -- * What passes between them
    Source,
    Tree,
    Scene,
    Diagnostic (..),
    code,
    severity,
    pretty,
    Language (..),
    Plan,
    Picture,
    pictureWidth,
    pictureHeight,
    pictureBytes,
  )
where

import Dioptre.Model.Library (noModels)
import Dioptre.Picture (Picture, pictureBytes, pictureHeight, pictureWidth)
import Dioptre.Picture.Png (encode)
import Dioptre.Render (rendered)
import Dioptre.Render.Row (Plan, plan)
import Dioptre.Scene (Scene)
import Dioptre.Scene.Check (checkScene)
import Dioptre.Source.Diagnostic (Diagnostic (..), code, severity)
import Dioptre.Source.Language (Language (..))
import Dioptre.Source.Report (pretty)
import Dioptre.Source.Text (Source, decode, fromText)
import Dioptre.Syntax.Grammar (parse)
import Dioptre.Syntax.Tree (Tree)

-- | The picture of a scene's text. Total: whatever the text, there is a picture.
--
-- Spec: conformance.total, limits.must-work.
draw :: Source -> Picture
draw = rendered . plan mempty noModels . fst . checkScene . parse

-- | What is wrong with a scene's text, in its order.
complaints :: Source -> [Diagnostic]
complaints = snd . checkScene . parse
